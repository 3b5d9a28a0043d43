#include "core/files/hash.h"

#include <array>

#include <openssl/evp.h>
#include <openssl/sha.h>

namespace artcal {
namespace {

// SHA256() and EVP_sha256() of OpenSSL look the algorithm up anew each time, which takes longer than a short text.
const EVP_MD* algorithm() {
  static const EVP_MD* const found = EVP_MD_fetch(nullptr, "SHA256", nullptr);  // until the process ends
  return found != nullptr ? found : EVP_sha256();
}

}  // namespace

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, algorithm(), nullptr);
  constexpr std::string_view digits = "0123456789abcdef";
  std::string hex;
  hex.reserve(2 * digest.size());
  for (const unsigned char byte : digest) {
    hex += digits[byte / 16];
    hex += digits[byte % 16];
  }
  return hex;
}

}  // namespace artcal
