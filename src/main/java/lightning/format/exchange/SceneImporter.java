package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.format.MeshFormat;
import lightning.format.mesh.MeshException;

/** Makes scenes of the files of other programs: glTF, OBJ, PLY and NFF. */
public final class SceneImporter {
    private SceneImporter() {}

    /**
     * Reads a file and all that belongs to it; writes nothing.
     *
     * @param sceneFile       where the scene will lie, and beside it what it needs
     * @param units    what the numbers of the file's lights are, where it has lights
     * @param progress hears how many KiB of a file are read
     * @throws MeshException         if anything is wrong with it
     * @throws IOException           if it cannot be read
     * @throws CancellationException if {@code progress} asked to stop
     */
    public static ImportedScene read(Path file, Path sceneFile, LightUnits units, Progress progress) throws IOException, MeshException {
        return switch (MeshFormat.detect(file)) {
            case PLY -> ObjImport.importPly(file, sceneFile, progress);
            case NFF -> NffImport.read(file, sceneFile, progress);
            case OBJ -> ObjImport.importObj(file, sceneFile, progress);
            case GLTF -> GltfImport.read(file, sceneFile, units, progress);
        };
    }
}
