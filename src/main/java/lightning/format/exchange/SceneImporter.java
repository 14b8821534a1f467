package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.format.MeshFormat;
import lightning.format.mesh.MeshException;

/** Importer of other programs' files: glTF, OBJ, PLY and NFF. */
public final class SceneImporter {
    private SceneImporter() {}

    /**
     * Reads a file and the files it references; writes nothing.
     *
     * @param sceneFile path of the future scene; assets are placed next to it
     * @param units units of the file's lights, if it has any
     * @param progress receives the number of KiB read
     * @throws MeshException if the content is invalid
     * @throws IOException if it cannot be read
     * @throws CancellationException if {@code progress} requested cancellation
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
