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
 * What the editor begins with, read from files.
 *
 * @param preview of its scene
 * @param failedFile the scene that was named, where it could not be opened for {@code failure}; else null
 * @param findRecoveries   what crashes left unsaved
 * @param fileToImport   a file of another program, of which a scene is made as soon as there is a window that can ask; else null
 */
record StartupFiles(OpenDocument document, StartupPreview preview, Path failedFile, Exception failure,
        List<RecoveryFolder.RecoverableScene> findRecoveries, Path fileToImport) {

    /** Whether a file is by its name a scene, or one of another program of which a scene can be made. */
    static boolean canOpen(String file) {
        return JenFile.isJenFileName(file) || MeshFormat.isMeshFileName(file);
    }

    /**
     * Reads a scene and begins to look at it; the first scene takes the place of one that cannot be opened, or is not made yet.
     *
     * @param preferences how the artist left the view
     * @throws IOException   if neither could be read
     * @throws JenException  if the first scene, which was read in place of the other, does not parse
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
