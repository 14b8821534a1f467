package lightning.serve;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.file.SharedMemoryFile;

/**
 * Files of one scene that clients map into their memory: one for each client's pictures, one for its coarse pictures, and one for each path that a
 * client names.
 */
final class SharedPictures {
    private final Server server;
    /** Coarse pictures of a client. Their size changes, so they would take the file of exact pictures away. */
    private record CoarseOf(Client client) {}

    /** Layers of a client, which are larger than pictures. */
    private record LayersOf(Client client) {}

    /** Files by client, coarse pictures of a client, or path. */
    private final Map<Object, SharedMemoryFile> files = new HashMap<>();

    SharedPictures(Server server) {
        this.server = server;
    }

    /**
     * Returns the file for a picture: the one of the last picture if it has the same size, else a new one in its place.
     *
     * @param path path that the client names; empty for a file in shared memory
     */
    SharedMemoryFile file(Client client, Optional<Path> path, long bytes) throws IOException {
        return file((Object) client, path, bytes);
    }

    /** Returns the file for a coarse picture, as {@link #file(Client, Optional, long)}. */
    SharedMemoryFile coarseFile(Client client, Optional<Path> path, long bytes) throws IOException {
        return file(new CoarseOf(client), path, bytes);
    }

    /** Returns the file for a picture with its layers, as {@link #file(Client, Optional, long)}. */
    SharedMemoryFile layersFile(Client client, Optional<Path> path, long bytes) throws IOException {
        return file(new LayersOf(client), path, bytes);
    }

    private SharedMemoryFile file(Object unnamed, Optional<Path> path, long bytes) throws IOException {
        Optional<Path> named = path.map(p -> p.toAbsolutePath().normalize());
        Object key = named.isPresent() ? named.get() : unnamed;
        SharedMemoryFile known = files.get(key);
        if (known != null && known.bytes() == bytes) {
            return known;
        }
        if (known != null) {
            files.remove(key);
            known.close();
        }
        SharedMemoryFile created = named.isPresent() ? server.createShared(named.get(), bytes)
                : SharedMemoryFile.create(server.newSharedPath(), bytes);
        files.put(key, created);
        return created;
    }

    /** Removes the files of a client. */
    void close(Client client) {
        Stream.of(client, new CoarseOf(client), new LayersOf(client)).map(files::remove).filter(Objects::nonNull)
                .forEach(SharedPictures::close);
    }

    /** Removes all files. */
    void close() {
        files.values().forEach(SharedPictures::close);
        files.clear();
    }

    private static void close(SharedMemoryFile file) {
        try {
            file.close();
        } catch (IOException e) {
            // The folder's end, or the next server, removes it.
        }
    }
}
