package lightning.bench.mesh;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import lightning.base.file.SearchPath;
import lightning.base.file.TemporaryFolder;
import lightning.scene.node.Mesh;

/**
 * Embree 3 in a separate process, driven by a bundled C program. The program is compiled if Embree's headers and a C compiler are
 * installed, and runs until closed.
 */
public final class Embree implements AutoCloseable {
    /** Name and settings of the measured program. */
    public static final String PROGRAM = "Embree 3, robust, packets of 16 and coherent, or single rays";

    private static final Path HEADER = Path.of("/usr/include/embree3/rtcore.h");
    private static final int CHUNK = 1 << 20;

    private final Path folder;
    private final Process process;
    private final Writer requests;
    private final BufferedReader responses;

    private Embree(Path folder, Process process) {
        this.folder = folder;
        this.process = process;
        requests = new OutputStreamWriter(process.getOutputStream(), StandardCharsets.UTF_8);
        responses = process.inputReader(StandardCharsets.UTF_8);
    }

    /** Returns whether Embree's headers and a C compiler are installed. */
    public static boolean isInstalled() {
        return Files.exists(HEADER) && compiler().isPresent();
    }

    private static Optional<Path> compiler() {
        return SearchPath.ofSystem().find("cc");
    }

    /**
     * Compiles the program and starts it.
     *
     * @return empty if Embree or a compiler is not installed
     * @throws IOException          if the program cannot be compiled or started; the message ends with the compiler's last line
     * @throws InterruptedException if this thread was interrupted meanwhile
     */
    public static Optional<Embree> start() throws IOException, InterruptedException {
        if (!isInstalled()) {
            return Optional.empty();
        }
        Path folder = Files.createTempDirectory("lightning-embree");
        try {
            return Optional.of(new Embree(folder, compileAndStart(folder, compiler().orElseThrow())));
        } catch (IOException | InterruptedException e) {
            TemporaryFolder.delete(folder);
            throw e;
        }
    }

    private static Process compileAndStart(Path folder, Path compiler) throws IOException, InterruptedException {
        try (InputStream source = Embree.class.getResourceAsStream("embree.c")) {
            Files.copy(source, folder.resolve("embree.c"));
        }
        Path log = folder.resolve("log");
        Process compilation =
                new ProcessBuilder(compiler.toString(), "-O3", "-march=native", "-o", "embree", "embree.c", "-lembree3", "-lm")
                        .directory(folder.toFile()).redirectErrorStream(true).redirectOutput(log.toFile()).start();
        try {
            if (compilation.waitFor() != 0) {
                String last = Files.readString(log, StandardCharsets.ISO_8859_1).lines().filter(line -> !line.isBlank())
                        .reduce("nothing", (_, line) -> line);
                throw new IOException("the Embree program does not compile: " + last.strip());
            }
        } finally {
            compilation.destroy();
        }
        return new ProcessBuilder(folder.resolve("embree").toString()).directory(folder.toFile())
                .redirectError(ProcessBuilder.Redirect.DISCARD).start();
    }

    private String request(String command) throws IOException {
        requests.write(command + "\n");
        requests.flush();
        String response = responses.readLine();
        if (response == null || response.startsWith("cannot")) {
            throw new IOException("the Embree program " + (response == null ? "ended" : response) + " on command: " + command);
        }
        return response;
    }

    /** Built BVH with build time and size. */
    public record TreeBuild(double ms, long bytes) {}

    /** Sets the mesh. */
    public void setMesh(Mesh mesh) throws IOException {
        Path file = folder.resolve("mesh");
        try (FileChannel to = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE,
                StandardOpenOption.TRUNCATE_EXISTING)) {
            ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * CHUNK).order(ByteOrder.LITTLE_ENDIAN);
            to.write(bytes.putInt(mesh.vertexCount()).putInt(mesh.triangleCount()).flip());
            for (int i = 0; i < mesh.positions().length; i += CHUNK) {
                FloatBuffer part = FloatBuffer.wrap(mesh.positions(), i, Math.min(CHUNK, mesh.positions().length - i));
                write(to, bytes, part.remaining(), b -> b.asFloatBuffer().put(part));
            }
            for (int i = 0; i < mesh.triangles().length; i += CHUNK) {
                IntBuffer part = IntBuffer.wrap(mesh.triangles(), i, Math.min(CHUNK, mesh.triangles().length - i));
                write(to, bytes, part.remaining(), b -> b.asIntBuffer().put(part));
            }
        }
        request("mesh " + file);
        Files.delete(file);
    }

    private interface BufferFiller {
        void fill(ByteBuffer bytes);
    }

    private static void write(FileChannel to, ByteBuffer bytes, int numbers, BufferFiller filler) throws IOException {
        bytes.clear();
        filler.fill(bytes);
        bytes.limit(Integer.BYTES * numbers);
        while (bytes.hasRemaining()) {
            to.write(bytes);
        }
    }

    /** Builds the BVH of the mesh. */
    public TreeBuild build(int threads) throws IOException {
        String[] response = request("build " + threads).split(" ");
        return new TreeBuild(1e3 * Double.parseDouble(response[0]), Long.parseLong(response[1]));
    }

    /** Sets the rays. */
    public void setRays(RaySet set) throws IOException {
        Path file = folder.resolve("rays");
        set.write(file);
        request("rays " + file);
        Files.delete(file);
    }

    /** Result of tracing all rays. */
    public record TraceResult(double ms, int hits) {}

    /** Traces the current rays of a kind on one thread; the time is milliseconds of its processor time. */
    public TraceResult trace(RaySet.Kind kind) throws IOException {
        String[] response = request(switch (kind) {
            case EYE, MIRRORED -> "nearest16";
            case SHADOW -> "blocked16";
            case SINGLE -> "nearest1";
        }).split(" ");
        return new TraceResult(1e3 * Double.parseDouble(response[0]), Integer.parseInt(response[1]));
    }

    /**
     * Reads the nearest hits of the current rays.
     *
     * @param distance receives distances, infinite for a miss; length at least the number of rays
     * @param triangle receives triangles, −1 for a miss
     */
    public void nearest(float[] distance, int[] triangle) throws IOException {
        Path file = folder.resolve("answers");
        request("write " + file);
        ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN);
        Files.delete(file);
        for (int i = 0; i < distance.length; i++) {
            distance[i] = bytes.getFloat();
            triangle[i] = bytes.getInt();
        }
    }

    @Override
    public void close() {
        process.destroy();
        try {
            process.waitFor();
            TemporaryFolder.delete(folder);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (IOException e) {
            // The system clears its own temporary folder.
        }
    }
}
