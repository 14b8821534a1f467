package lightning.editor.window;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import lightning.editor.document.OpenDocument;
import lightning.editor.document.RecoveryFolder;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.StartupPreview;
import lightning.format.MeshFormat;
import lightning.format.jen.JenException;
import lightning.format.jen.JenFile;

/**
 * Everything that the editor reads from files at its start.
 *
 * @param preview preview of the document's scene
 * @param failedFile file that could not be opened because of {@code failure}; null if there is none
 * @param findRecoveries finds unsaved scenes of earlier crashes
 * @param fileToImport file of another program, to import as soon as a window can show the import dialog; null if there is none
 */
record StartupFiles(OpenDocument document, StartupPreview preview, Path failedFile, Exception failure,
        List<RecoveryFolder.RecoverableScene> findRecoveries, Path fileToImport) {

    /** Returns true if a file's name is that of a scene or of a format that can be imported. */
    static boolean canOpen(String file) {
        return JenFile.isJenFileName(file) || MeshFormat.isMeshFileName(file);
    }

    /**
     * Reads a scene and starts its preview. Reads the default scene if the file cannot be opened or has to be imported first.
     *
     * @param preferences stored view settings
     * @throws IOException if neither file can be read
     * @throws JenException if the default scene does not parse
     */
    static StartupFiles read(Path file, Preferences preferences, RecoveryFolder recovery) throws IOException, JenException {
        List<RecoveryFolder.RecoverableScene> recoveries = findRecoveries(recovery);
        if (MeshFormat.isMeshFileName(file.toString())) {
            return of(OpenDocument.open(EditorPaths.defaultScene()), preferences, null, null, recoveries, file);
        }
        try {
            return of(OpenDocument.open(file), preferences, null, null, recoveries, null);
        } catch (IOException | JenException | RuntimeException e) {
            try {
                return of(OpenDocument.open(EditorPaths.defaultScene()), preferences, file, e, recoveries, null);
            } catch (IOException | JenException fallbackFailure) {
                fallbackFailure.addSuppressed(e);
                throw e;
            }
        }
    }

    private static StartupFiles of(OpenDocument document, Preferences preferences, Path failedFile, Exception failure,
            List<RecoveryFolder.RecoverableScene> recoveries,
            Path fileToImport) {
        return new StartupFiles(document, StartupSession.startPreview(document, preferences), failedFile, failure, recoveries,
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
