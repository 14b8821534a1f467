package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.format.MeshFormat;
import lightning.format.mesh.MeshException;

/** Makes scenes of the files of other programs: glTF, OBJ, PLY and NFF. */
public final class Importer {
    private Importer() {}

    /**
     * Reads a file and all that belongs to it; writes nothing.
     *
     * @param to       where the scene will lie, and beside it what it needs
     * @param units    what the numbers of the file's lights are, where it has lights
     * @param progress hears how many KiB of a file are read
     * @throws MeshException         if anything is wrong with it
     * @throws IOException           if it cannot be read
     * @throws CancellationException if {@code progress} asked to stop
     */
    public static Import read(Path file, Path to, LightUnits units, Progress progress) throws IOException, MeshException {
        return switch (MeshFormat.of(file)) {
            case PLY -> ObjImport.ply(file, to, progress);
            case NFF -> NffImport.read(file, to, progress);
            case OBJ -> ObjImport.obj(file, to, progress);
            case GLTF -> GltfImport.read(file, to, units, progress);
        };
    }
}
