package lightning.format.gltf;

import java.io.IOException;
import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.base.file.OrdinaryFile;
import lightning.base.text.Quote;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.MeshException;

/** The bytes that a glTF file names: embedded, beside its JSON, or in files of its folder. Each is read once. */
final class Buffers {
    private final GltfFile file;
    private final Map<Integer, byte[]> read = new HashMap<>();
    private final Map<String, byte[]> byUri = new HashMap<>();

    Buffers(GltfFile file) {
        this.file = file;
    }

    /**
     * The bytes of a view.
     *
     * @return from the first to the last byte of it, in the order of glTF, the smallest first
     */
    ByteBuffer view(Json index) throws IOException, MeshException {
        Json view = index.in(file.array("bufferViews"));
        byte[] bytes = buffer(view.get("buffer").index(file.array("buffers")));
        int offset = view.get("byteOffset").whole(0, bytes.length, 0);
        int length = view.get("byteLength").whole(0, bytes.length - offset);
        return GltfFile.little(bytes).slice(offset, length).order(ByteOrder.LITTLE_ENDIAN);
    }

    private byte[] buffer(int index) throws IOException, MeshException {
        byte[] known = read.get(index);
        if (known != null) {
            return known;
        }
        Json buffer = file.array("buffers").at(index);
        Json uri = buffer.get("uri");
        byte[] bytes;
        if (uri.isThere()) {
            bytes = named(uri);
        } else if (index == 0 && file.binary() != null) {
            bytes = file.binary();
        } else {
            throw buffer.problem("must have a uri: there are no data beside the JSON for it");
        }
        int length = buffer.get("byteLength").whole(0, Integer.MAX_VALUE);
        if (length > bytes.length) {
            throw buffer.get("byteLength").problem("must be at most the bytes that are there, " + bytes.length + ", was " + length);
        }
        read.put(index, bytes);
        return bytes;
    }

    /** The files of this folder that hold buffers, each once. */
    Set<Path> files() throws IOException, MeshException {
        Set<Path> files = new LinkedHashSet<>();
        Json buffers = file.array("buffers");
        for (int i = 0; i < buffers.size(); i++) {
            Json uri = buffers.at(i).get("uri");
            if (uri.isThere() && !uri.text().orElse("").startsWith("data:")) {
                files.add(beside(uri));
            }
        }
        return files;
    }

    /** The same, read once however many buffers name it. */
    private byte[] named(Json uri) throws IOException, MeshException {
        String text = uri.text().orElse("");
        byte[] known = byUri.get(text);
        if (known == null) {
            known = bytes(uri);
            byUri.put(text, known);
        }
        return known;
    }

    /** What a URI names: data in it, or a file of this folder. */
    byte[] bytes(Json uri) throws IOException, MeshException {
        String text = uri.text().orElse("");
        if (text.startsWith("data:")) {
            int comma = text.indexOf(',');
            if (comma < 0 || !text.substring(0, comma).endsWith(";base64")) {
                throw uri.problem("must hold its data as base64");
            }
            try {
                return Base64.getDecoder().decode(text.substring(comma + 1));
            } catch (IllegalArgumentException e) {
                throw uri.problem("must hold its data as base64: " + e.getMessage());
            }
        }
        Path path = beside(uri);
        try (ByteSource source = ByteSource.open(path, file.progress())) {
            return source.bytes((int) source.left());
        } catch (MeshException e) {
            throw uri.problem(e.getMessage());
        }
    }

    /** The file of this folder, or of one inside it, that a URI names. */
    Path beside(Json uri) throws IOException, MeshException {
        String text = uri.text().orElse("");
        Path folder = file.path().toAbsolutePath().getParent().toRealPath();
        try {
            // A plus is a plus in paths.
            Path path = folder.resolve(URLDecoder.decode(text.replace("+", "%2B"), StandardCharsets.UTF_8)).normalize();
            if (text.isEmpty() || text.contains(":") || !path.startsWith(folder)) {
                throw uri.problem("must be data or a file in the folder of this one, was " + Quote.of(text));
            }
            if (!Files.exists(path)) {
                throw uri.problem("there is no file " + Quote.of(text));
            }
            Optional<String> other = OrdinaryFile.other(path);
            if (other.isPresent()) {
                throw uri.problem("must be a file in the folder of this one, was " + Quote.of(text) + ", which is " + other.get());
            }
            if (!path.toRealPath().startsWith(folder)) {
                throw uri.problem("must be in the folder of this file, found a link that leads out of it, " + Quote.of(text));
            }
            return path;
        } catch (IllegalArgumentException e) {
            throw uri.problem("must be data or a file in the folder of this one, was " + Quote.of(text));
        }
    }
}
