package lightning.format.gltf;

import static java.util.Objects.requireNonNull;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.base.work.TimeLimit;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * glTF file in memory: its JSON and the binary chunk of a {@code .glb}.
 *
 * @param isBinary     true for a {@code .glb} file
 * @param decodingTime time for decoding all primitives
 */
public record GltfFile(Path path, JsonValue root, boolean isBinary, byte @Nullable [] binaryChunk, Progress progress,
        TimeLimit decodingTime) {
    static final byte[] MAGIC = "glTF".getBytes(StandardCharsets.US_ASCII);
    static final int JSON_CHUNK = 0x4E4F534A;
    static final int BINARY_CHUNK = 0x004E4942;
    /** Bytes before the JSON of a binary file, and the place of its length. */
    private static final int BINARY_START = 20;
    private static final int BINARY_JSON_LENGTH = 12;
    /** Bytes of JSON that are searched for addresses. */
    private static final int MAX_SEARCHED = 1 << 25;
    /** Maximum number of JSON values, names and brackets; an object for each takes some hundred bytes. */
    private static final long MAX_TOKENS = 5_000_000;
    private static final int MAX_NESTING = 200;
    static final JsonMapper JSON = JsonMapper.builder(JsonFactory.builder().streamReadConstraints(StreamReadConstraints.builder()
            .maxStringLength(MeshLimits.FILE_BYTES).maxDocumentLength(MeshLimits.FILE_BYTES).maxTokenCount(MAX_TOKENS)
            .maxNestingDepth(MAX_NESTING).build()).build()).build();
    /** Extensions that are supported, or whose use by a material is noted with its name. */
    private static final Set<String> SUPPORTED_EXTENSIONS =
            Set.of("KHR_lights_punctual", "KHR_mesh_quantization", "KHR_texture_transform", "KHR_materials_unlit",
                    "KHR_materials_emissive_strength", "KHR_materials_specular", "KHR_materials_ior", "KHR_materials_transmission",
                    "KHR_materials_variants", "KHR_materials_volume", "KHR_materials_clearcoat", "KHR_materials_sheen",
                    "KHR_materials_anisotropy", "KHR_materials_iridescence", "KHR_materials_dispersion",
                    "KHR_materials_diffuse_transmission", "KHR_animation_pointer", "KHR_node_visibility",
                    "EXT_mesh_gpu_instancing", "KHR_draco_mesh_compression",
                    "EXT_texture_webp", "EXT_meshopt_compression");

    /** Starts of names of extensions without which a scene only looks different. */
    private static final List<String> APPEARANCE = List.of("KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_");

    private GltfFile(Path path, JsonNode root, boolean isBinary, byte @Nullable [] binaryChunk, Progress progress) {
        this(path, new JsonValue(path, "", root), isBinary, binaryChunk, progress, new TimeLimit(DracoPrimitive.TIME));
    }

    /** Returns whether a file starts like a glTF file, in either form. */
    public static boolean isGltf(ByteSource source) throws IOException {
        if (source.startsWith(MAGIC)) {
            return true;
        }
        int c = source.peek();
        return c == '{' || source.startsWith(new byte[] {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF, '{'});
    }

    /** Returns whether a file may name further ones: glTF with addresses. Reads only the JSON of binary files. */
    public static boolean mayNameFiles(Path file) throws IOException {
        try (InputStream in = RegularFile.open(file, "a mesh file")) {
            ByteBuffer start = littleEndian(in.readNBytes(BINARY_START));
            if (!Arrays.equals(MAGIC, 0, MAGIC.length, start.array(), 0, Math.min(MAGIC.length, start.limit()))) {
                // JSON, perhaps after a byte order mark.
                return start.hasRemaining() && (start.get(0) == '{' || start.get(0) == (byte) 0xEF);
            }
            int json = start.limit() < BINARY_START ? -1 : start.getInt(BINARY_JSON_LENGTH);
            return json < 0 || json > MAX_SEARCHED || new String(in.readNBytes(json), StandardCharsets.UTF_8).contains("\"uri\"");
        }
    }

    /** Returns the name and version of the program that wrote the file; empty if it does not say. */
    public String generator() {
        return root.node().path("asset").path("generator").asString("");
    }

    /**
     * Reads a file, without its external buffers.
     *
     * @throws MeshException if it is not glTF 2.0 (for glTF 1.0 the message names the remedy), or requires an extension
     *     without which its geometry is unknown
     * @throws IOException if it cannot be read
     */
    public static GltfFile read(Path path, Progress progress) throws IOException, MeshException {
        try (ByteSource source = ByteSource.openText(path, progress)) {
            return read(source, progress);
        }
    }

    /** @see #read(Path, Progress) */
    public static GltfFile read(ByteSource source, Progress progress) throws IOException, MeshException {
        return read(source, progress, JSON);
    }

    private static GltfFile read(ByteSource source, Progress progress, JsonMapper json) throws IOException, MeshException {
        try {
            GltfFile file = source.startsWith(MAGIC) ? readBinary(source, progress, json)
                    : new GltfFile(source.file(), parse(source, source.bytes((int) source.remaining()), json), false, null, progress);
            file.checkVersion();
            return file;
        } catch (EOFException e) {
            throw source.problem("", "the file ends too early");
        }
    }

    /** Reads a file with another JSON parser, such as one that keeps all digits. */
    static GltfFile readExactly(Path path, Progress progress, JsonMapper json) throws IOException, MeshException {
        try (ByteSource source = ByteSource.open(path, progress)) {
            return read(source, progress, json);
        }
    }

    private static GltfFile readBinary(ByteSource source, Progress progress, JsonMapper mapper) throws IOException, MeshException {
        source.int32();
        int version = source.int32();
        if (version == 1) {
            throw versionOneProblem(source.file());
        }
        if (version != 2) {
            throw source.problem("version", "must be 2, was " + Integer.toUnsignedString(version));
        }
        source.int32();
        JsonNode json = parse(source, requireNonNull(readChunk(source, JSON_CHUNK, "JSON")), mapper);
        byte[] data = null;
        while (source.remaining() >= 8 && data == null) {
            data = readChunk(source, BINARY_CHUNK, "BIN");
        }
        return new GltfFile(source.file(), json, true, data, progress);
    }

    /** Reads a chunk; returns null if it is one of extensions, after that of the JSON, which readers must skip. */
    private static byte @Nullable [] readChunk(ByteSource source, int type, String name) throws IOException, MeshException {
        long length = source.int32() & 0xFFFF_FFFFL;
        int found = source.int32();
        if (found != type && type == JSON_CHUNK) {
            throw source.problem("chunk " + name, "must come next, found one of another type");
        }
        if (length > source.remaining()) {
            throw source.problem("chunk " + name, "has " + length + " bytes by its header, but only " + source.remaining() + " follow");
        }
        byte[] content = source.bytes((int) length);
        return found == type ? content : null;
    }

    private static JsonNode parse(ByteSource source, byte[] json, JsonMapper mapper) throws MeshException {
        try (JsonParser parser = mapper.createParser(json)) {
            JsonNode root = readTree(parser, source);
            if (!root.isObject()) {
                throw source.problem("", "must be a JSON object");
            }
            return root;
        } catch (JacksonException e) {
            var location = e.getLocation();
            throw source.problem(location == null ? "" : "line " + location.getLineNr() + ", column " + location.getColumnNr(),
                    "is not valid JSON: " + e.getOriginalMessage());
        }
    }

    /** Parses the whole text; a parser that keeps all digits rejects huge exponents. */
    private static JsonNode readTree(JsonParser parser, ByteSource source) throws MeshException {
        try {
            JsonNode root = parser.readValueAsTree();
            if (root == null || parser.nextToken() != null) {
                throw source.problem("", "must be a single JSON object");
            }
            return root;
        } catch (NumberFormatException e) {
            var location = parser.currentTokenLocation();
            throw source.problem("line " + location.getLineNr() + ", column " + location.getColumnNr(),
                    "must be a number with an exponent below 2147483648, was " + Quote.of(parser.getString()));
        }
    }

    private void checkVersion() throws MeshException {
        JsonValue version = root.get("asset").get("version");
        if (isVersionOne(version)) {
            throw versionOneProblem(path);
        }
        if (!version.text().orElse("").startsWith("2.")) {
            throw version.problem("must be 2.0, was " + version.text().orElse("missing"));
        }
        JsonValue required = root.get("extensionsRequired");
        for (int i = 0; i < required.size(); i++) {
            String name = required.element(i).text().orElse("");
            if (!SUPPORTED_EXTENSIONS.contains(name) && APPEARANCE.stream().noneMatch(name::startsWith)) {
                throw required.element(i).problem("requires " + name + ", which Lightning does not support; export without it");
            }
        }
    }

    /** Returns true for glTF 1.0, whose version may be missing or a number, and whose meshes have names instead of indices. */
    private boolean isVersionOne(JsonValue version) {
        String text = version.node().asString("");
        return version.isPresent() ? text.equals("1") || text.startsWith("1.") : root.node().path("meshes").isObject();
    }

    private static MeshException versionOneProblem(Path path) {
        return new OldGltfException(path);
    }

    /** Notes the used extensions that are not supported. */
    public void noteExtensions(ConversionNotes notes) throws MeshException {
        JsonValue used = root.get("extensionsUsed");
        for (int i = 0; i < used.size(); i++) {
            String name = used.element(i).text().orElse("");
            if (!SUPPORTED_EXTENSIONS.contains(name)) {
                notes.add("extensions " + name);
            }
        }
    }

    JsonValue array(String name) throws MeshException {
        return root.get(name);
    }

    /** Returns the number of cameras. */
    public int cameraCount() throws MeshException {
        return array("cameras").size();
    }

    /** Returns the name of a camera; empty if it has none. */
    public String cameraName(int camera) throws MeshException {
        return array("cameras").element(camera).get("name").text().orElse("");
    }

    /** Returns the files in the folder of this one, or below it, that contain buffers, each once. */
    public Set<Path> bufferFiles() throws IOException, MeshException {
        return buffers().files();
    }

    /** Returns the reader of this file's buffers. */
    BufferReader buffers() {
        return new BufferReader(this);
    }

    static ByteBuffer littleEndian(byte[] bytes) {
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }
}
