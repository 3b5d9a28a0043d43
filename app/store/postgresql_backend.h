#pragma once

#include <soci/soci-backend.h>

namespace artcal {

/// SOCI's backend for PostgreSQL, loaded where a store is first opened on a server: libpq brings some thirty libraries
/// (TLS, LDAP, Kerberos), and binding their symbols took a fifth of the start of every command. Throws
/// std::runtime_error where it is not installed.
const soci::backend_factory& postgresql_backend();

}  // namespace artcal
