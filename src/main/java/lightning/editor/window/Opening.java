package lightning.editor.window;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import lightning.editor.document.OpenDocument;
import lightning.editor.document.Recovery;
import lightning.editor.window.model.Glimpse;
import lightning.editor.window.model.Preferences;
import lightning.format.MeshFormat;
import lightning.format.jen.JenException;
import lightning.format.jen.JenFile;

/**
 * What the editor begins with, read from files.
 *
 * @param glimpse of its scene
 * @param failed the scene that was named, where it could not be opened for {@code why}; else null
 * @param left   what crashes left unsaved
 * @param next   a file of another program, of which a scene is made as soon as there is a window that can ask; else null
 */
record Opening(OpenDocument document, Glimpse glimpse, Path failed, Exception why, List<Recovery.Found> left, Path next) {

    /** Whether a file is by its name a scene, or one of another program of which a scene can be made. */
    static boolean isNamedSo(String file) {
        return JenFile.isNamedSo(file) || MeshFormat.isNamedSo(file);
    }

    /**
     * Reads a scene and begins to look at it; the first scene takes the place of one that cannot be opened, or is not made yet.
     *
     * @param preferences how the artist left the view
     * @throws IOException   if neither could be read
     * @throws JenException  if the first scene, which was read in place of the other, does not parse
     */
    static Opening read(Path file, Preferences preferences, Recovery recovery) throws IOException, JenException {
        List<Recovery.Found> left = left(recovery);
        if (MeshFormat.isNamedSo(file.toString())) {
            return of(OpenDocument.open(Folders.firstScene()), preferences, null, null, left, file);
        }
        try {
            return of(OpenDocument.open(file), preferences, null, null, left, null);
        } catch (IOException | JenException | RuntimeException e) {
            try {
                return of(OpenDocument.open(Folders.firstScene()), preferences, file, e, left, null);
            } catch (IOException | JenException again) {
                again.addSuppressed(e);
                throw e;
            }
        }
    }

    private static Opening of(OpenDocument document, Preferences preferences, Path failed, Exception why, List<Recovery.Found> left,
            Path next) {
        return new Opening(document, FirstSight.look(document, preferences), failed, why, left, next);
    }

    private static List<Recovery.Found> left(Recovery recovery) {
        try {
            return recovery.found();
        } catch (IOException e) {
            return List.of();
        }
    }
}
