package lightning.format.assimp;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.IntBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import lightning.base.file.RegularFile;
import org.jspecify.annotations.Nullable;
import org.lwjgl.assimp.AIMesh;
import org.lwjgl.assimp.AIPropertyStore;
import org.lwjgl.assimp.AIScene;
import org.lwjgl.assimp.Assimp;
import org.lwjgl.system.MemoryUtil;

/** Conversion of a file to glTF by Assimp, in a process of its own: native code may end it at any time. */
public final class AssimpProcess {
    /** Smooth normals where the file has none, meters, and triangles only; lines and points become meshes of their own. */
    private static final int STEPS = Assimp.aiProcess_Triangulate | Assimp.aiProcess_JoinIdenticalVertices | Assimp.aiProcess_GlobalScale
            | Assimp.aiProcess_SortByPType | Assimp.aiProcess_GenSmoothNormals | Assimp.aiProcess_RemoveComponent;
    private static final int POLL_MILLISECONDS = 5;
    /** Sizes of this process on Linux, in pages: reserved and in memory come first. */
    private static final Path RESIDENT = Path.of("/proc/self/statm");
    private static final int MAX_SIZES = 1000;
    private static final long PAGE_BYTES = MemoryUtil.PAGE_SIZE;
    /** Angle between faces above which an edge of a mesh without normals is sharp, as other programs do. */
    private static final float MAX_SMOOTH_DEGREES = 30;
    /** Exit code of the process if the conversion fails, with the reason as a line of the error stream. */
    public static final int FAILED = 3;
    static final int OUT_OF_MEMORY = 4;

    private AssimpProcess() {}

    /**
     * Converts a file, and ends this process if its caller ends or the conversion takes too much memory.
     *
     * @param output  new file, glTF in one file
     * @param memory  bytes that the conversion may take
     * @param isAnimated whether animations are kept
     * @return a line for each kind of things that the new file lacks: its name, a tab and its number
     * @throws IOException if Assimp cannot read the file or write the other one; the message says why
     */
    public static List<String> convert(Path file, Path output, long memory, boolean isAnimated) throws IOException {
        endWithCaller();
        limitMemory(memory);
        // Tangents follow from the coordinates, and the writer gives them a type that glTF does not have.
        int removed = Assimp.aiComponent_TANGENTS_AND_BITANGENTS;
        AIScene scene = read(file, isAnimated ? removed : removed | Assimp.aiComponent_ANIMATIONS);
        keepTwoCoordinates(scene);
        if (Assimp.aiExportScene(scene, "glb2", output.toString(), 0) != Assimp.aiReturn_SUCCESS) {
            throw new IOException("it cannot be converted " + Assimp.aiGetErrorString());
        }
        List<String> losses = new ArrayList<>(GlbLights.add(output, scene, file));
        losses.addAll(TextureLosses.of(scene));
        // The scene is not released: this process ends.
        return losses;
    }

    /** Leaves out the third component of texture coordinates, which glTF does not have. */
    private static void keepTwoCoordinates(AIScene scene) {
        for (int i = 0; i < scene.mNumMeshes(); i++) {
            IntBuffer components = AIMesh.create(requireNonNull(scene.mMeshes()).get(i)).mNumUVComponents();
            for (int k = 0; k < components.capacity(); k++) {
                components.put(k, Math.min(components.get(k), 2));
            }
        }
    }

    /** @param removed parts of the scene to leave out, as Assimp's components */
    private static AIScene read(Path file, int removed) throws IOException {
        AIPropertyStore settings = requireNonNull(Assimp.aiCreatePropertyStore());
        try {
            // Pivots would become nodes of their own.
            Assimp.aiSetImportPropertyInteger(settings, Assimp.AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, 0);
            Assimp.aiSetImportPropertyInteger(settings, Assimp.AI_CONFIG_PP_RVC_FLAGS, removed);
            Assimp.aiSetImportPropertyFloat(settings, Assimp.AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, MAX_SMOOTH_DEGREES);
            @Nullable
            AIScene scene =
                    Assimp.aiImportFileExWithProperties(file.toString(), STEPS,
                            null, settings);
            if (scene == null) {
                throw new IOException(String.valueOf(Assimp.aiGetErrorString()));
            }
            return scene;
        } finally {
            Assimp.aiReleasePropertyStore(settings);
        }
    }

    /** Ends this process when its input ends. */
    private static void endWithCaller() {
        Thread.ofPlatform().daemon().name("caller").start(() -> {
            try {
                while (System.in.read() >= 0) {
                    // The caller sends nothing.
                }
            } catch (IOException e) {
                // It has ended as well.
            }
            Runtime.getRuntime().halt(1);
        });
    }

    private static void limitMemory(long bytes) {
        long start = memory();
        Thread.ofPlatform().daemon().name("memory").start(() -> {
            while (memory() - start < bytes) {
                try {
                    Thread.sleep(Duration.ofMillis(POLL_MILLISECONDS));
                } catch (InterruptedException e) {
                    return;
                }
            }
            Runtime.getRuntime().halt(OUT_OF_MEMORY);
        });
    }

    /** Returns the bytes that this process has in memory; on systems other than Linux, those it has reserved. */
    private static long memory() {
        try {
            return Long.parseLong(new String(RegularFile.readBytes(RESIDENT, "sizes", MAX_SIZES), StandardCharsets.US_ASCII).split(" ")[1])
                    * PAGE_BYTES;
        } catch (IOException e) {
            return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
                    .getCommittedVirtualMemorySize();
        }
    }
}
