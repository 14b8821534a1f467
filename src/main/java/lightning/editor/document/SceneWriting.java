package lightning.editor.document;

import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Set;
import lightning.base.file.ChangedFileException;
import lightning.base.file.FileState;
import lightning.base.file.ReadOnlyFileException;
import lightning.base.file.SafeFile;
import lightning.base.text.Texts;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.shot.AnimatedScene;

/**
 * A scene on its way to a file: what the document held when it was to be saved, whatever is edited meanwhile.
 *
 * @param from    what the document's file holds
 * @param allowed what may be lost in the target
 */
record SceneWriting(SavedScene from, AnimatedScene content, Path target, Set<Consent> allowed) {
    SceneWriting {
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
        JenDocument text = from.document().with(content);
        boolean own = target.toAbsolutePath().equals(from.file().toAbsolutePath());
        Path file = own ? from.file() : target;
        return new SavedScene(file, text.save(own ? Consent.to(file, from.state(), allowed) : elsewhere(text)), text);
    }

    private SafeFile elsewhere(JenDocument text) throws IOException {
        try {
            JenReader.read(text.text(), target.toString(), target.toAbsolutePath().getParent());
        } catch (JenException e) {
            throw new IOException(Texts.of("the scene cannot be read from there: {0}", e.problems().getFirst()), e);
        }
        Set<Consent> more = EnumSet.of(Consent.OVERWRITE_CHANGED);
        more.addAll(allowed);
        return Consent.to(target, FileState.NONE, more);
    }
}
