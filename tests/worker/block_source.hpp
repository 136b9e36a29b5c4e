// A worker that serves blocks to others, up to the limit a test sets.
#pragma once

#include "tests/worker/cut_body.hpp"
#include "worker/peers/peer_server.hpp"

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace cd::tests {

/// Holds some blocks of one body, and makes the directions to fetch them.
struct BlockSource {
    BlockSource(const asio::any_io_executor& executor, const CutBody& of, TreeId id)
        : held_body(of),
          held_tree(id),
          server(PeerServer::listen(executor, {"127.0.0.1", 0}).value()) {
        server->serve(key, [this](const SubtreeKey& slot) {
            const auto block = blocks.find(slot.root);
            return block == blocks.end() || slot.tree != held_tree ? nullptr : block->second;
        });
    }

    void hold(RootIndex root) {
        blocks[root] = std::make_shared<const SubtreeBlock>(held_body.blocks[root]);
    }
    void hold_all() {
        for (RootIndex root = 0; root < held_body.blocks.size(); ++root) {
            hold(root);
        }
    }

    /// Makes a source with the master's ticket for these roots; 0: the source's own port.
    PeerSource
    ticket_for(const std::vector<RootIndex>& roots, WorkerId worker, std::uint16_t port = 0) {
        const Sha256 proof = ticket_proof(key, ++ticket, held_tree, roots);
        return {worker, "127.0.0.1", port == 0 ? server->port() : port, ticket, proof};
    }
    /// Makes directions without a source.
    [[nodiscard]] FetchFromPeers question(std::vector<RootIndex> roots) const {
        FetchFromPeers made;
        made.tree = held_tree;
        made.roots = std::move(roots);
        for (const RootIndex root : made.roots) {
            made.hashes.push_back(held_body.blocks[root].hash);
        }
        return made;
    }
    FetchFromPeers directions(std::vector<RootIndex> roots, std::uint16_t port = 0) {
        FetchFromPeers made = question(std::move(roots));
        made.sources = {ticket_for(made.roots, WorkerId{1}, port)};
        return made;
    }

    const CutBody& held_body;
    TreeId held_tree;
    PeerKey key = random_secret();
    std::map<RootIndex, std::shared_ptr<const SubtreeBlock>> blocks;
    std::shared_ptr<PeerServer> server;
    std::uint64_t ticket = 0;
};

} // namespace cd::tests
