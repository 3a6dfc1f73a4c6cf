#include "process/blob_exchange.hpp"

#include <utility>

namespace trace {

Blob BlobExchange::get(const std::string& key, const Make& make) {
  if (!supervisor_) return make_blob(make());
  if (const Blob* kept = kept_.find(key)) return *kept;

  Message wanted;
  wanted.kind = MessageKind::blob_wanted;
  wanted.body = key;
  supervisor_->send(std::move(wanted));
  const std::optional<Message> reply = supervisor_->receive();
  if (!reply) return make_blob(make());  // the supervisor is gone, and soon this process

  Blob blob;
  if (reply->kind == MessageKind::blob_make) {
    blob = make_and_share(key, make);
  } else {
    std::optional<Blob> mapped = map_blob(reply->descriptor);
    blob = mapped ? std::move(*mapped) : make_blob(make());
  }
  kept_.put(key, blob, blob.bytes.size());
  return blob;
}

Blob BlobExchange::make_and_share(const std::string& key, const Make& make) {
  Message result;
  result.kind = MessageKind::blob_not_made;
  result.body = key;
  Blob blob;
  try {
    blob = make_blob(make());
  } catch (...) {
    supervisor_->send(std::move(result));
    throw;
  }
  Descriptor shared = share_bytes(blob.bytes);
  if (std::optional<Blob> mapped = map_blob(shared)) {
    blob = std::move(*mapped);  // the private copy is let go
    result.kind = MessageKind::blob_made;
    result.descriptor = std::move(shared);
  }
  supervisor_->send(std::move(result));
  return blob;
}

}  // namespace trace
