package lightning.editor.window.model;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.editor.document.FileThread;
import lightning.format.jen.FileCopy;
import lightning.format.jen.FileKind;

/** Brings files from elsewhere to where the open scene finds them; over another of that name only if one is chosen twice. */
public final class FileBringer {
    private final SceneEditor editor;
    private final FileThread files;
    private BiFunction<String, FileKind, Optional<Path>> asks = (_, _) -> Optional.empty();
    /** A file that was chosen, whose name another has; null where there is none. */
    private Path asked;

    FileBringer(SceneEditor editor, FileThread files) {
        this.editor = editor;
        this.files = files;
    }

    /** The folder that the open scene lies in. */
    public Path folder() {
        return editor.document().file().toAbsolutePath().getParent();
    }

    /** Reads the files that the scene finds there. */
    public FileThread files() {
        return files;
    }

    /** Says who asks for a file; it gets the title of the question. */
    public void setBrowse(BiFunction<String, FileKind, Optional<Path>> browse) {
        asks = browse;
    }

    /**
     * Asks for a file from anywhere and brings it, unless the artist thinks better of it.
     *
     * @param title   of the question
     * @param brought hears the name by which the scene finds it
     * @param refused hears why it was not brought
     */
    public void browse(String title, FileKind kind, Consumer<String> brought, Consumer<String> refused) {
        asks.apply(title, kind).ifPresent(file -> bring(kind, file, brought, refused));
    }

    private void bring(FileKind kind, Path file, Consumer<String> brought, Consumer<String> refused) {
        Path folder = folder();
        boolean overwrite = file.equals(asked);
        files.beside(() -> FileCopy.bring(kind, file, folder, overwrite), outcome -> {
            asked = outcome instanceof FileCopy.Taken ? file : null;
            switch (outcome) {
                case FileCopy.Brought(String name) -> brought.accept(name);
                case FileCopy.Taken(String name) -> refused.accept(
                        Texts.of("Another file {0} is among the textures: choose it again to write over it", Quote.of(name)));
            }
        }, why -> refused.accept(Sentence.of(why)));
    }
}
