package lightning.editor.document;

import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Set;
import lightning.base.file.AtomicFile;
import lightning.base.file.ChangedFileException;
import lightning.base.file.FileState;
import lightning.base.file.ReadOnlyFileException;
import lightning.base.text.Messages;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.shot.AnimatedScene;

/**
 * A scene on its way to a file: what the document held when it was to be saved, whatever is edited meanwhile.
 *
 * @param source    what the document's file holds
 * @param allowed what may be lost in the target
 */
record SaveRequest(SavedScene source, AnimatedScene content, Path target, Set<OverwriteConfirmation> allowed) {
    SaveRequest {
        allowed = Set.copyOf(allowed);
    }

    /**
     * Writes it, on any thread. In all failures the file is unchanged.
     *
     * @throws ChangedFileException  if the file holds what somebody else wrote, unless that may be overwritten
     * @throws ReadOnlyFileException if the file is read-only, unless that may be replaced
     * @throws IOException           if it cannot be written, or could not be read again there because its textures are not
     *                               found from that folder
     */
    SavedScene write() throws IOException {
        JenDocument text = source.document().withAnimatedScene(content);
        boolean isOwnFile = target.toAbsolutePath().equals(source.file().toAbsolutePath());
        Path file = isOwnFile ? source.file() : target;
        return new SavedScene(file,
                text.save(isOwnFile ? OverwriteConfirmation.safeFile(file, source.state(), allowed) : checkedTarget(text)), text);
    }

    private AtomicFile checkedTarget(JenDocument text) throws IOException {
        try {
            JenReader.read(text.text(), target.toString(), target.toAbsolutePath().getParent());
        } catch (JenException e) {
            throw new IOException(Messages.tr("the saved scene cannot be read: {0}", e.problems().getFirst()), e);
        }
        Set<OverwriteConfirmation> allAllowed = EnumSet.of(OverwriteConfirmation.OVERWRITE_CHANGED);
        allAllowed.addAll(allowed);
        return OverwriteConfirmation.safeFile(target, FileState.MISSING, allAllowed);
    }
}
