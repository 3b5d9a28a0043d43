#include "app/store/postgresql_backend.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace artcal {
namespace {

constexpr const char* library = "libsoci_postgresql.so.4.0";

const soci::backend_factory* load() {
  using Factory = const soci::backend_factory* (*)();
  void* const loaded = ::dlopen(library, RTLD_NOW | RTLD_LOCAL);  // for the rest of the process
  const auto factory = loaded != nullptr ? reinterpret_cast<Factory>(::dlsym(loaded, "factory_postgresql")) : nullptr;
  if (factory == nullptr) {
    throw std::runtime_error(std::string("stores on PostgreSQL need ") + library +
                             ", which is not installed (Debian: libsoci-postgresql4.0)");
  }
  return factory();
}

}  // namespace

const soci::backend_factory& postgresql_backend() {
  static const soci::backend_factory* const factory = load();
  return *factory;
}

}  // namespace artcal
