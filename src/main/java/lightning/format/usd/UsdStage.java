package lightning.format.usd;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import lightning.base.file.RegularFile;
import lightning.base.math.Transform;
import lightning.base.work.Progress;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.json.JsonMapper;

/**
 * Description of a stage: JSON, and arrays to which it refers by place and length in bytes. All of it is checked when it is read, since a
 * hostile stage decides what the converter writes.
 */
public final class UsdStage {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final int MAX_BYTES = 1 << 30;
    private static final int MATRIX_SIZE = 16;
    private static final List<String> EXTENSIONS = List.of(".usd", ".usda", ".usdc", ".usdz");

    private final JsonValue root;
    private final FileChannel arrays;

    private UsdStage(JsonValue root, FileChannel arrays) {
        this.root = root;
        this.arrays = arrays;
    }

    /** What is done with a stage while its files exist. */
    public interface Use<T> {
        T read(UsdStage stage) throws IOException, MeshException;
    }

    /** Returns the file extensions of stages, in lower case. */
    public static List<String> extensions() {
        return EXTENSIONS;
    }

    /** Returns whether a file has the name of a stage. */
    public static boolean isStageName(String file) {
        return EXTENSIONS.stream().anyMatch(file.toLowerCase(Locale.ROOT)::endsWith);
    }

    /**
     * Reads a stage with the converter in Python.
     *
     * @throws MeshException if usd-core cannot read it, it does not have what is chosen, or what it says is invalid
     * @throws IOException if the file cannot be read, or there is no Python with usd-core
     */
    public static <T> T read(Path source, StageChoice choice, Progress progress, Use<T> use) throws IOException, MeshException {
        return UsdConverter.installed().convert(source, choice, progress, folder -> open(source, folder, use));
    }

    /**
     * Reads what the converter wrote.
     *
     * @param source the stage's file, for messages
     */
    static <T> T open(Path source, Path folder, Use<T> use) throws IOException, MeshException {
        try (FileChannel arrays = FileChannel.open(folder.resolve("arrays.bin"), StandardOpenOption.READ)) {
            var root = new JsonValue(source, "",
                    JSON.readTree(RegularFile.readBytes(folder.resolve("stage.json"), "a file of the converter", MAX_BYTES)));
            root.get("version").integer(1, 1);
            return use.read(new UsdStage(root, arrays));
        } catch (JacksonException e) {
            throw new MeshException(source, "", "the description of the stage is not valid JSON: " + e.getOriginalMessage());
        }
    }

    /** Returns the description. */
    public JsonValue root() {
        return root;
    }

    /** Returns 32-bit whole numbers; empty if absent. */
    public int[] ints(JsonValue ref) throws IOException, MeshException {
        ByteBuffer bytes = bytes(ref, Integer.BYTES);
        int[] values = new int[bytes.remaining() / Integer.BYTES];
        bytes.asIntBuffer().get(values);
        return values;
    }

    /** Returns 32-bit numbers; empty if absent. */
    public float[] floats(JsonValue ref) throws IOException, MeshException {
        ByteBuffer bytes = bytes(ref, Float.BYTES);
        float[] values = new float[bytes.remaining() / Float.BYTES];
        bytes.asFloatBuffer().get(values);
        return values;
    }

    /** Returns transforms, of 16 numbers each; empty if absent. */
    public Transform[] transforms(JsonValue ref) throws IOException, MeshException {
        ByteBuffer bytes = bytes(ref, MATRIX_SIZE * Double.BYTES);
        var result = new Transform[bytes.remaining() / (MATRIX_SIZE * Double.BYTES)];
        double[] m = new double[MATRIX_SIZE];
        for (int i = 0; i < result.length; i++) {
            bytes.asDoubleBuffer().get(m);
            bytes.position(bytes.position() + MATRIX_SIZE * Double.BYTES);
            result[i] = transform(m);
        }
        return result;
    }

    /** Returns a transform of 16 numbers; the identity if absent. */
    public static Transform transform(JsonValue matrix) throws MeshException {
        return transform(matrix.numbers(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1));
    }

    /** Returns a transform of 16 numbers. Transposes them: usd-core multiplies rows by matrices. */
    public static Transform transform(double[] m) {
        return new Transform(m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14]);
    }

    /** Returns the place of a file that the stage names; empty if it is missing. */
    public static Optional<Path> place(JsonValue file) throws MeshException {
        return file.get("place").text().filter(s -> !s.isEmpty()).map(Path::of).filter(Files::isRegularFile);
    }

    private ByteBuffer bytes(JsonValue ref, int unit) throws IOException, MeshException {
        if (!ref.isPresent()) {
            return ByteBuffer.allocate(0);
        }
        long size = arrays.size();
        int offset = ref.element(0).integer(0, (int) Math.min(size, Integer.MAX_VALUE));
        int length = ref.element(1).integer(0, (int) Math.min(size - offset, Integer.MAX_VALUE));
        if (length % unit != 0) {
            throw ref.problem("must have a multiple of " + unit + " bytes, has " + length);
        }
        ByteBuffer bytes = ByteBuffer.allocate(length).order(ByteOrder.nativeOrder());
        while (bytes.hasRemaining() && arrays.read(bytes, (long) offset + bytes.position()) >= 0) {
            // A channel may read less than asked for.
        }
        return bytes.flip();
    }
}
