package lightning.format;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.format.gltf.GltfFile;
import lightning.format.gltf.GltfMeshes;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.NamedMesh;
import lightning.format.mesh.Notes;
import lightning.format.mesh.obj.ObjReader;
import lightning.format.mesh.ply.PlyReader;
import lightning.format.nff.NffFile;
import lightning.format.nff.NffReader;

/** Reads files of meshes: PLY, OBJ, NFF and glTF. */
public final class MeshFiles {
    /** The name of the one mesh in a file that names none. */
    public static final String ONLY_PART = "mesh";
    /** How the names of such files end. */
    public static final List<String> ENDINGS = List.of(".ply", ".obj", ".nff", ".gltf", ".glb");

    private MeshFiles() {}

    /** Whether a file is one of meshes by its name. */
    public static boolean isNamedSo(String file) {
        String name = file.toLowerCase(Locale.ROOT);
        return ENDINGS.stream().anyMatch(name::endsWith);
    }

    /**
     * Reads all meshes of a file. No memory is taken for what a file says to hold and does not.
     *
     * @param progress hears how many KiB are read
     * @return at least one, in the order of the file
     * @throws MeshException         if its content is wrong; the message says where
     * @throws IOException           if it cannot be read, or is a folder, a pipe or a device
     * @throws CancellationException if {@code progress} asked to stop
     */
    public static List<NamedMesh> read(Path file, Progress progress) throws IOException, MeshException {
        try (ByteSource source = ByteSource.open(file, progress)) {
            return switch (MeshFormat.of(file, source)) {
                case PLY -> List.of(new NamedMesh(ONLY_PART, PlyReader.read(source, new Notes())));
                case OBJ ->
                        ObjReader.read(source, new Notes()).parts().stream().map(part -> new NamedMesh(part.name(), part.mesh())).toList();
                case NFF -> polygons(NffReader.read(source, new Notes()), source);
                case GLTF -> GltfMeshes.read(GltfFile.read(source, progress), new Notes()).stream()
                        .map(part -> new NamedMesh(part.name(), part.triangles())).toList();
            };
        }
    }

    private static List<NamedMesh> polygons(NffFile file, ByteSource source) throws MeshException {
        if (file.meshes().isEmpty()) {
            throw source.problem("", "must have polygons or patches to be a mesh; import it as a scene");
        }
        return file.meshes().stream().map(surface -> new NamedMesh(surface.name(), surface.mesh())).toList();
    }
}
