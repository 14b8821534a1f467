package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.format.MeshFormat;
import lightning.format.assimp.AssimpConverter;
import lightning.format.assimp.AssimpFormat;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.exchange.usd.UsdImport;
import lightning.format.mesh.MeshException;
import lightning.format.usd.UsdStage;
import lightning.format.usd.UsdSubdivision;

/** Importer of other programs' files: glTF, OBJ, PLY, NFF and USD, and those that Assimp converts. */
public final class SceneImporter {
    /** Default number of refinements of subdivision surfaces. */
    public static final int DEFAULT_LEVELS = UsdSubdivision.DEFAULT_LEVELS;
    /** Largest number of refinements of subdivision surfaces. */
    public static final int MAX_LEVELS = UsdSubdivision.MAX_LEVELS;

    private SceneImporter() {}

    /** Returns the file extensions that can be imported, in lower case. */
    public static List<String> extensions() {
        return Stream.of(MeshFormat.allExtensions(), UsdStage.extensions(), AssimpFormat.extensions()).flatMap(List::stream).toList();
    }

    /** Returns whether a file has the name of one that can be imported. */
    public static boolean isImportName(String file) {
        return MeshFormat.isMeshFileName(file) || UsdStage.isStageName(file) || AssimpFormat.isModelName(file);
    }

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
        return read(file, sceneFile, units, DEFAULT_LEVELS, "", progress);
    }

    /**
     * Reads a file and the files it references; writes nothing.
     *
     * @param sceneFile path of the future scene; assets are placed next to it
     * @param units units of the file's lights, if it has any
     * @param levels refinements of a stage's subdivision surfaces, from 0 to {@link #MAX_LEVELS}
     * @param variant name of the variant of a glTF file's materials; empty for its own materials
     * @param progress receives the number of KiB read
     * @throws MeshException if the content is invalid, or it has no such variant
     * @throws IOException if it cannot be read
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static ImportedScene read(Path file, Path sceneFile, LightUnits units, int levels, String variant, Progress progress)
            throws IOException, MeshException {
        boolean isStage = UsdStage.isStageName(file.toString());
        boolean isModel = AssimpFormat.isModelName(file.toString());
        if (!variant.isEmpty() && (isStage || isModel || MeshFormat.detect(file) != MeshFormat.GLTF)) {
            throw new MeshException(file, "", "must be a glTF file to have the variant " + Quote.of(variant) + " of its materials");
        }
        if (isStage) {
            RegularFile.open(file, "a USD file").close();
            return UsdImport.read(file, sceneFile, levels, progress);
        }
        if (isModel) {
            return AssimpConverter.convert(file, progress,
                    (glb, losses) -> GltfImport.readConverted(file, glb, losses, sceneFile, units, progress));
        }
        return switch (MeshFormat.detect(file)) {
            case PLY -> ObjImport.importPly(file, sceneFile, progress);
            case NFF -> NffImport.read(file, sceneFile, progress);
            case OBJ -> ObjImport.importObj(file, sceneFile, progress);
            case GLTF -> GltfImport.read(file, sceneFile, units, variant, progress);
        };
    }
}
