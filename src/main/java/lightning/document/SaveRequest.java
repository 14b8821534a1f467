package lightning.document;

import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Set;
import lightning.base.file.AtomicFile;
import lightning.base.file.ChangedFileException;
import lightning.base.file.FileState;
import lightning.base.file.ParentFolder;
import lightning.base.file.ReadOnlyFileException;
import lightning.base.file.ShippedFile;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.format.jen.AssetCopies;
import lightning.format.jen.InputFiles;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.shot.AnimatedScene;

/**
 * Snapshot of a document to be saved, independent of later edits.
 *
 * @param source  content of the document's file
 * @param untitled whether the source is not the document's own file: it is not overwritten, and files that the scene references are copied
 * @param allowed confirmed overwrites of the target
 */
public record SaveRequest(SavedScene source, AnimatedScene content, Path target, boolean untitled, Set<OverwriteConfirmation> allowed) {
    public SaveRequest {
        allowed = Set.copyOf(allowed);
    }

    /**
     * Writes the file, on any thread. On failure the file is unchanged.
     *
     * @throws ChangedFileException  if another program changed the file, unless confirmed
     * @throws ReadOnlyFileException if the file is read-only, unless confirmed
     * @throws IOException           if the file cannot be written, or not be read again because textures are missing in its folder
     */
    public SavedScene write() throws IOException {
        JenDocument text = source.document().withAnimatedScene(content);
        boolean isSource = target.toAbsolutePath().equals(source.file().toAbsolutePath());
        if (isSource && untitled && !source.state().equals(FileState.MISSING) || ShippedFile.isShipped(target)) {
            throw new IOException(Messages.tr("{0} comes with Lightning and stays as it is; choose another file",
                    Quote.path(target.getFileName())));
        }
        InputFiles.referencedBy(content.base(), ParentFolder.of(source.file())).check(target);
        boolean isOwnFile = isSource && !untitled;
        Path file = isOwnFile ? source.file() : target;
        if (untitled) {
            AssetCopies.copy(content.base(), ParentFolder.of(source.file()), ParentFolder.of(target));
        }
        return new SavedScene(file,
                text.save(isOwnFile ? OverwriteConfirmation.safeFile(file, source.state(), allowed) : checkedTarget(text)), text);
    }

    private AtomicFile checkedTarget(JenDocument text) throws IOException {
        try {
            JenDocument saved = JenReader.read(text.text(), target.toString(), ParentFolder.of(target));
            if (saved.notes().size() > source.document().notes().size()) {
                saved.requireAllFiles();
            }
        } catch (JenException e) {
            throw new IOException(Messages.tr("the saved scene cannot be read: {0}", e.problems().getFirst()), e);
        }
        Set<OverwriteConfirmation> allAllowed = EnumSet.of(OverwriteConfirmation.OVERWRITE_CHANGED);
        allAllowed.addAll(allowed);
        return OverwriteConfirmation.safeFile(target, FileState.MISSING, allAllowed);
    }
}
