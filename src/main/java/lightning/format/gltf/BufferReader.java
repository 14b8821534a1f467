package lightning.format.gltf;

import java.io.IOException;
import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.base.file.ParentFolder;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.MeshException;

/** Reader for the buffers of a glTF file: embedded, in the binary chunk, or in files of its folder. Each is read once. */
final class BufferReader {
    private static final int MAX_STRIDE = 256;

    private final GltfFile file;
    private final Map<Integer, byte[]> buffersByIndex = new HashMap<>();
    private final Map<String, byte[]> buffersByUri = new HashMap<>();
    /** Compressed buffer views that were decoded. */
    private final Map<Integer, byte[]> decodedViews = new HashMap<>();
    private long decodedBytes;

    BufferReader(GltfFile file) {
        this.file = file;
    }

    /**
     * Returns the bytes of a buffer view.
     *
     * @return little-endian, exactly the view's range
     */
    ByteBuffer view(JsonValue index) throws IOException, MeshException {
        JsonValue view = index.resolve(file.array("bufferViews"));
        JsonValue compressed = view.get("extensions").get("EXT_meshopt_compression");
        if (compressed.isPresent()) {
            int number = index.index(file.array("bufferViews"));
            byte[] decoded = decodedViews.get(number);
            if (decoded == null) {
                decoded = decoded(compressed);
                decodedViews.put(number, decoded);
            }
            return GltfFile.littleEndian(decoded);
        }
        byte[] bytes = buffer(view.get("buffer").index(file.array("buffers")));
        int offset = view.get("byteOffset").integer(0, bytes.length, 0);
        int length = view.get("byteLength").integer(0, bytes.length - offset);
        return GltfFile.littleEndian(bytes).slice(offset, length).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Decodes a compressed buffer view. */
    private byte[] decoded(JsonValue compressed) throws IOException, MeshException {
        byte[] bytes = buffer(compressed.get("buffer").index(file.array("buffers")));
        int offset = compressed.get("byteOffset").integer(0, bytes.length, 0);
        int length = compressed.get("byteLength").integer(0, bytes.length - offset);
        int stride = compressed.get("byteStride").integer(1, MAX_STRIDE);
        int count = compressed.get("count").integer(1, Integer.MAX_VALUE / stride);
        String mode = compressed.get("mode").text().orElse("");
        String filter = compressed.get("filter").text().orElse("NONE");
        decodedBytes += (long) count * stride;
        new ExpansionLimit(file).checkBytes(decodedBytes, compressed);
        byte[] data = Arrays.copyOfRange(bytes, offset, offset + length);
        boolean isIndex = mode.equals("TRIANGLES") || mode.equals("INDICES");
        if (isIndex ? stride != 2 && stride != 4 || mode.equals("TRIANGLES") && count % 3 != 0
                : !mode.equals("ATTRIBUTES") || stride % 4 != 0 || filter.equals("OCTAHEDRAL") && stride != 4 && stride != 8
                        || filter.equals("QUATERNION") && stride != 8) {
            throw compressed
                    .problem("must have a mode, a filter and a byteStride that fit together, has '" + mode + "', '" + filter + "' and "
                            + stride);
        }
        try {
            if (isIndex) {
                return packed(mode.equals("TRIANGLES") ? MeshoptCodec.triangles(data, count) : MeshoptCodec.indices(data, count), stride);
            }
            byte[] values = MeshoptCodec.attributes(data, count, stride);
            switch (filter) {
                case "OCTAHEDRAL" -> MeshoptCodec.decodeOctahedral(values, stride);
                case "QUATERNION" -> MeshoptCodec.decodeQuaternion(values);
                case "EXPONENTIAL" -> MeshoptCodec.decodeExponential(values);
                default -> {}
            }
            return values;
        } catch (IndexOutOfBoundsException | IllegalArgumentException e) {
            throw compressed.problem("must be undamaged data of meshoptimizer: " + e.getMessage());
        }
    }

    private static byte[] packed(int[] indices, int stride) {
        ByteBuffer out = GltfFile.littleEndian(new byte[indices.length * stride]);
        for (int index : indices) {
            if (stride == 2) {
                out.putShort((short) index);
            } else {
                out.putInt(index);
            }
        }
        return out.array();
    }

    private byte[] buffer(int index) throws IOException, MeshException {
        byte[] cached = buffersByIndex.get(index);
        if (cached != null) {
            return cached;
        }
        JsonValue buffer = file.array("buffers").element(index);
        JsonValue uri = buffer.get("uri");
        byte[] bytes;
        if (uri.isPresent()) {
            bytes = cachedBytes(uri);
        } else if (index == 0 && file.binaryChunk() != null) {
            bytes = file.binaryChunk();
        } else {
            throw buffer.problem("must have a uri: the file has no binary chunk for it");
        }
        int length = buffer.get("byteLength").integer(0, Integer.MAX_VALUE);
        if (length > bytes.length) {
            throw buffer.get("byteLength").problem("must be at most the available bytes, " + bytes.length + ", was " + length);
        }
        buffersByIndex.put(index, bytes);
        return bytes;
    }

    /** Returns the files of this folder that contain buffers, each once. */
    Set<Path> files() throws IOException, MeshException {
        Set<Path> files = new LinkedHashSet<>();
        JsonValue buffers = file.array("buffers");
        for (int i = 0; i < buffers.size(); i++) {
            JsonValue uri = buffers.element(i).get("uri");
            if (uri.isPresent() && !uri.text().orElse("").startsWith("data:")) {
                files.add(siblingFile(uri));
            }
        }
        return files;
    }

    /** Returns the bytes of a URI, read once for all buffers that reference it. */
    private byte[] cachedBytes(JsonValue uri) throws IOException, MeshException {
        String text = uri.text().orElse("");
        byte[] cached = buffersByUri.get(text);
        if (cached == null) {
            cached = bytes(uri);
            buffersByUri.put(text, cached);
        }
        return cached;
    }

    /** Returns the bytes of a URI: embedded data, or a file of this folder. */
    byte[] bytes(JsonValue uri) throws IOException, MeshException {
        String text = uri.text().orElse("");
        if (text.startsWith("data:")) {
            int comma = text.indexOf(',');
            if (comma < 0 || !text.substring(0, comma).endsWith(";base64")) {
                throw uri.problem("must contain its data as base64");
            }
            try {
                return Base64.getDecoder().decode(text.substring(comma + 1));
            } catch (IllegalArgumentException e) {
                throw uri.problem("must contain its data as base64: " + e.getMessage());
            }
        }
        Path path = siblingFile(uri);
        try (ByteSource source = ByteSource.open(path, file.progress())) {
            return source.bytes((int) source.remaining());
        } catch (MeshException e) {
            throw uri.problem(String.valueOf(e.getMessage()));
        }
    }

    /** Returns the file in this folder or below it that a URI references. */
    Path siblingFile(JsonValue uri) throws IOException, MeshException {
        String text = uri.text().orElse("");
        Path folder = ParentFolder.of(file.path()).toRealPath();
        try {
            // A plus sign is literal in paths.
            Path path = folder.resolve(URLDecoder.decode(text.replace("+", "%2B"), StandardCharsets.UTF_8)).normalize();
            if (text.isEmpty() || text.contains(":") || !path.startsWith(folder)) {
                throw uri.problem("must be data or a file in the folder of this one, was " + Quote.of(text));
            }
            if (!Files.exists(path)) {
                throw uri.problem("there is no file " + Quote.of(text));
            }
            Optional<String> otherKind = RegularFile.describeIrregular(path);
            if (otherKind.isPresent()) {
                throw uri.problem("must be a file in the folder of this one, was " + Quote.of(text) + ", which is " + otherKind.get());
            }
            if (!path.toRealPath().startsWith(folder)) {
                throw uri.problem("must be in the folder of this file, found a link to another folder, " + Quote.of(text));
            }
            return path;
        } catch (IllegalArgumentException e) {
            throw uri.problem("must be data or a file in the folder of this one, was " + Quote.of(text));
        }
    }
}
