package lightning.format;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.format.gltf.GltfFile;
import lightning.format.gltf.GltfMeshReader;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.NamedMesh;
import lightning.format.mesh.obj.ObjReader;
import lightning.format.mesh.ply.PlyReader;
import lightning.format.nff.NffFile;
import lightning.format.nff.NffReader;
import org.jspecify.annotations.Nullable;

/**
 * File format of meshes and of other programs' scenes, detected by the file's content, or by its name if the content has no
 * signature.
 */
public enum MeshFormat {
    PLY("PLY", PlyReader::isPly, ".ply") {
        @Override
        List<NamedMesh> meshes(ByteSource source, Progress progress) throws IOException, MeshException {
            return List.of(new NamedMesh(SINGLE_PART_NAME, PlyReader.read(source, new ConversionNotes())));
        }
    },
    OBJ("OBJ", null, ".obj") {
        @Override
        List<NamedMesh> meshes(ByteSource source, Progress progress) throws IOException, MeshException {
            return ObjReader.read(source, new ConversionNotes()).parts().stream().map(part -> new NamedMesh(part.name(), part.mesh()))
                    .toList();
        }
    },
    NFF("NFF", null, ".nff") {
        @Override
        List<NamedMesh> meshes(ByteSource source, Progress progress) throws IOException, MeshException {
            NffFile file = NffReader.read(source, new ConversionNotes());
            if (file.meshes().isEmpty()) {
                throw source.problem("", "must have polygons or patches to be a mesh; import it as a scene");
            }
            return file.meshes().stream().map(surface -> new NamedMesh(surface.name(), surface.mesh())).toList();
        }
    },
    GLTF("glTF", GltfFile::isGltf, ".gltf", ".glb") {
        @Override
        List<NamedMesh> meshes(ByteSource source, Progress progress) throws IOException, MeshException {
            return GltfMeshReader.read(GltfFile.read(source, progress), new ConversionNotes()).stream()
                    .map(part -> new NamedMesh(part.name(), part.triangles())).toList();
        }
    };

    /** Name of the single mesh in a file without mesh names. */
    public static final String SINGLE_PART_NAME = "mesh";

    private final String title;
    /** Tests the first bytes of a file; null if the format has no signature. */
    private final @Nullable SignatureTest signature;
    private final List<String> extensions;

    private interface SignatureTest {
        boolean matches(ByteSource source) throws IOException;
    }

    MeshFormat(String title, @Nullable SignatureTest signature, String... extensions) {
        this.title = title;
        this.signature = signature;
        this.extensions = List.of(extensions);
    }

    abstract List<NamedMesh> meshes(ByteSource source, Progress progress) throws IOException, MeshException;

    /** Returns the format's name, language-independent. */
    public String title() {
        return title;
    }

    /** Returns the file extensions of all formats, in lower case. */
    public static List<String> allExtensions() {
        return Arrays.stream(values()).flatMap(format -> format.extensions.stream()).toList();
    }

    /** Returns whether the file's name has the extension of a format. */
    public static boolean isMeshFileName(String file) {
        return Arrays.stream(values()).anyMatch(format -> format.matchesName(file));
    }

    private boolean matchesName(String file) {
        return extensions.stream().anyMatch(file.toLowerCase(Locale.ROOT)::endsWith);
    }

    /**
     * Returns the format of a file.
     *
     * @throws MeshException if the file has none of these formats
     * @throws IOException if it cannot be read, or is a folder, a pipe or a device
     */
    public static MeshFormat detect(Path file) throws IOException, MeshException {
        try (ByteSource source = ByteSource.openText(file, Progress.NONE)) {
            return detect(file, source);
        }
    }

    /** Returns the format of an open file, without consuming any bytes. */
    private static MeshFormat detect(Path file, ByteSource source) throws IOException, MeshException {
        for (MeshFormat format : values()) {
            if (format.signature != null && format.signature.matches(source)) {
                return format;
            }
        }
        for (MeshFormat format : values()) {
            if (format.signature == null && format.matchesName(file.getFileName().toString())) {
                return format;
            }
        }
        throw source.problem("", "must be a PLY, OBJ, NFF or glTF file, found an unsupported format");
    }

    /**
     * Returns the files that a mesh file names and that are needed to read it, each once: external buffers of glTF, in its folder or below.
     *
     * @throws MeshException if the content is invalid, or a file that it names is missing
     * @throws IOException if it cannot be read
     */
    public static Set<Path> furtherFiles(Path file) throws IOException, MeshException {
        return GltfFile.mayNameFiles(file) ? GltfFile.read(file, Progress.NONE).bufferFiles() : Set.of();
    }

    /**
     * Reads all meshes of a file. Allocates no memory for data that the file declares but does not contain.
     *
     * @param progress receives the number of KiB read
     * @return at least one mesh, in file order
     * @throws MeshException if the content is invalid; the message contains the position
     * @throws IOException if it cannot be read, or is a folder, a pipe or a device
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static List<NamedMesh> meshes(Path file, Progress progress) throws IOException, MeshException {
        try (ByteSource source = ByteSource.openText(file, progress)) {
            return detect(file, source).meshes(source, progress);
        }
    }
}
