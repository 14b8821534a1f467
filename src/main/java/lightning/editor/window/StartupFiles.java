package lightning.editor.window;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import lightning.document.NewScene;
import lightning.document.OpenDocument;
import lightning.document.PictureArea;
import lightning.document.RecoveryFolder;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.StartupPreview;
import lightning.format.exchange.SceneImporter;
import lightning.format.jen.JenException;
import lightning.format.jen.JenFile;
import org.jspecify.annotations.Nullable;

/**
 * Everything that the editor reads from files at its start.
 *
 * @param isStartScene true if no file was named, so that the picture gets the size of its pane
 * @param preview preview of the document's scene
 * @param failedFile file that could not be opened because of {@code failure}; null if there is none
 * @param findRecoveries finds unsaved scenes of earlier crashes
 * @param fileToImport file of another program, to import as soon as a window can show the import dialog; null if there is none
 */
record StartupFiles(OpenDocument document, boolean isStartScene, StartupPreview preview, @Nullable Path failedFile,
        @Nullable Exception failure, List<RecoveryFolder.RecoverableScene> findRecoveries, @Nullable Path fileToImport) {

    /** Returns whether a file's name is that of a scene or of a format that can be imported. */
    static boolean canOpen(String file) {
        return JenFile.isJenFileName(file) || SceneImporter.isImportName(file);
    }

    /**
     * Reads a scene and starts its preview: a copy of the default scene if no file is named. A file that has to be imported first opens
     * behind an empty scene, not behind another picture; one that cannot be opened is replaced by a new scene.
     *
     * @param file named file; null if there is none
     * @param preferences stored view settings
     * @throws IOException if the default scene cannot be read
     * @throws JenException if the default scene does not parse
     */
    static StartupFiles read(@Nullable Path file, Preferences preferences, RecoveryFolder recovery) throws IOException, JenException {
        List<RecoveryFolder.RecoverableScene> recoveries = findRecoveries(recovery);
        if (file == null) {
            OpenDocument document = OpenDocument.openCopy(EditorPaths.defaultScene());
            return new StartupFiles(document, true, StartupSession.startPreview(document, preferences), null, null, recoveries, null);
        }
        if (SceneImporter.isImportName(file.toString())) {
            return of(NewScene.createEmpty(), preferences, null, null, recoveries, file);
        }
        try {
            return of(OpenDocument.open(file), preferences, null, null, recoveries, null);
        } catch (IOException | JenException | RuntimeException e) {
            return of(NewScene.create(PictureArea.DEFAULT), preferences, file, e, recoveries, null);
        }
    }

    private static StartupFiles of(OpenDocument document, Preferences preferences, @Nullable Path failedFile, @Nullable Exception failure,
            List<RecoveryFolder.RecoverableScene> recoveries, @Nullable Path fileToImport) {
        return new StartupFiles(document, false, StartupSession.startPreview(document, preferences), failedFile, failure, recoveries,
                fileToImport);
    }

    private static List<RecoveryFolder.RecoverableScene> findRecoveries(RecoveryFolder recovery) {
        try {
            return recovery.list();
        } catch (IOException e) {
            return List.of();
        }
    }
}
