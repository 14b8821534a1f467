package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
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
import lightning.format.gltf.OldGltfException;
import lightning.format.mesh.LimitException;
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
        return read(file, sceneFile, ImportOptions.DEFAULT.withUnits(Optional.of(units)), progress);
    }

    /**
     * Reads a file and the files it references; writes nothing.
     *
     * @param sceneFile path of the future scene; assets are placed next to it
     * @param progress receives the number of KiB read
     * @throws MeshException if the content is invalid, it lacks a camera or a variant of the options, or its format has none
     * @throws IOException if it cannot be read
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static ImportedScene read(Path file, Path sceneFile, ImportOptions options, Progress progress)
            throws IOException, MeshException {
        if (UsdStage.isStageName(file.toString())) {
            RegularFile.open(file, "a USD file").close();
            return UsdImport.read(file, sceneFile, options.levels(), options.stage(), progress);
        }
        boolean isModel = AssimpFormat.isModelName(file.toString());
        Optional<MeshFormat> format = isModel ? Optional.empty() : Optional.of(MeshFormat.detect(file));
        boolean isGltf = format.equals(Optional.of(MeshFormat.GLTF));
        checkOptions(file, options, isGltf, isGltf || isModel);
        if (format.isEmpty()) {
            return convert(file, sceneFile, options, progress);
        }
        return switch (format.get()) {
            case PLY -> ObjImport.importPly(file, sceneFile, progress);
            case NFF -> importNff(file, sceneFile, options, progress);
            case OBJ -> ObjImport.importObj(file, sceneFile, progress);
            case GLTF -> importGltf(file, sceneFile, options, progress);
        };
    }

    private static ImportedScene importGltf(Path file, Path sceneFile, ImportOptions options, Progress progress)
            throws IOException, MeshException {
        try {
            return GltfImport.read(file, sceneFile, options, progress);
        } catch (OldGltfException e) {
            return convert(file, sceneFile, options, progress, e);
        }
    }

    /** Reads NFF; other dialects, such as that of Sense8, by Assimp. */
    private static ImportedScene importNff(Path file, Path sceneFile, ImportOptions options, Progress progress)
            throws IOException, MeshException {
        try {
            return NffImport.read(file, sceneFile, progress);
        } catch (LimitException e) {
            throw e;
        } catch (MeshException e) {
            return convert(file, sceneFile, options, progress, e);
        }
    }

    /** @param problem thrown if Assimp cannot read the file either */
    private static ImportedScene convert(Path file, Path sceneFile, ImportOptions options, Progress progress, MeshException problem)
            throws IOException, MeshException {
        try {
            return convert(file, sceneFile, options, progress);
        } catch (MeshException e) {
            throw problem;
        }
    }

    private static ImportedScene convert(Path file, Path sceneFile, ImportOptions options, Progress progress)
            throws IOException, MeshException {
        return AssimpConverter.convert(file, progress,
                (glb, losses) -> GltfImport.readConverted(file, glb, losses, sceneFile, options, progress));
    }

    private static void checkOptions(Path file, ImportOptions options, boolean isGltf, boolean hasCameras) throws MeshException {
        if (!options.variants().isEmpty() && !isGltf) {
            throw new MeshException(file, "", "must be a glTF or USD file to have the variant " + Quote.of(options.variants().getFirst()));
        }
        if (options.variants().size() > 1) {
            throw new MeshException(file, "",
                    "must be a USD file to have several variants at a time, found " + Quote.list(options.variants()));
        }
        if (!options.camera().isEmpty() && !hasCameras) {
            throw new MeshException(file, "",
                    "must be a glTF, USD or FBX file, or another of the kind, to have the camera " + Quote.of(options.camera()));
        }
        if (options.frame().isPresent()) {
            throw new MeshException(file, "", "must be a USD file to be read at one frame");
        }
    }
}
