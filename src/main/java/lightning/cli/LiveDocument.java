package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.file.AtomicFile;
import lightning.base.file.ChangedFileException;
import lightning.base.file.FileErrorMessage;
import lightning.base.file.FileState;
import lightning.base.text.PrintableText;
import lightning.base.text.RefusalException;
import lightning.cli.output.Console;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenFile;
import lightning.review.Review;
import lightning.review.live.LiveChange;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Scene of a live review without an editor. Applies changes of pages, saves them and prints their notes before pages get an answer, so that
 * stopping the command loses nothing. Never overwrites what another program wrote: it goes on in a file of another name. Thread-safe.
 */
final class LiveDocument {
    private final Console console;
    private JenDocument document;
    /** File of the changes; null for none. */
    private @Nullable Path file;
    private FileState known = FileState.MISSING;
    private boolean isSaved = true;
    private final Map<String, List<Review.Note>> printed = new HashMap<>();

    /** @param file file of the changes; null for none. An existing one is replaced unless it changes from now on */
    LiveDocument(Console console, JenDocument document, @Nullable Path file) throws IOException {
        this.console = console;
        this.document = document;
        this.file = file;
        known = file == null ? FileState.MISSING : FileState.of(file);
    }

    synchronized Scene scene() {
        return document.scene();
    }

    /** Applies a change; returns the page that made it, which shows its values already, or an empty name if the scene does not allow it. */
    synchronized String apply(LiveChange change) {
        Scene before = document.scene();
        String page = change.page();
        try {
            document = document.withScene(change.state().applyTo(before));
        } catch (RefusalException e) {
            console.warn("a change was left out: %s", e.getMessage());
            page = "";
        }
        print(change);
        isSaved &= document.scene().equals(before);
        save();
        return page;
    }

    /** Saves changes that are not saved yet. A failed write is reported, and repeated by the next call. */
    synchronized void save() {
        Path target = file;
        if (isSaved || target == null) {
            return;
        }
        try {
            known = document.save(AtomicFile.of(target).ifUnchanged(known));
            isSaved = true;
        } catch (ChangedFileException e) {
            saveElsewhere(target, e);
        } catch (IOException e) {
            console.warn("%s; the next change is saved with this one", FileErrorMessage.of(e));
        }
    }

    /** Goes on in a new file with a number in its name. */
    private void saveElsewhere(Path target, ChangedFileException reason) {
        Path other = unused(target);
        try {
            known = document.save(AtomicFile.of(other).ifUnchanged(FileState.MISSING));
            isSaved = true;
            file = other;
            console.warn("%s; the review is saved to %s from now on", reason.getMessage(), other);
        } catch (IOException e) {
            console.warn("%s; %s; the next change is saved with this one", reason.getMessage(), FileErrorMessage.of(e));
        }
    }

    private static Path unused(Path file) {
        String stem = JenFile.stem(file.getFileName().toString());
        Path other = file.resolveSibling(stem + "-2" + JenFile.EXTENSION);
        for (int n = 3; Files.exists(other); n++) {
            other = file.resolveSibling(stem + "-" + n + JenFile.EXTENSION);
        }
        return other;
    }

    private void print(LiveChange change) {
        List<Review.Note> before = printed.getOrDefault(change.page(), List.of());
        String reviewer = change.reviewer().isBlank() ? "an unnamed reviewer" : PrintableText.escape(change.reviewer());
        for (Review.Note note : change.notes()) {
            if (!before.contains(note)) {
                console.print("%s, %d,%d: %s", reviewer, (int) (note.x() * scene().picture().width()),
                        (int) (note.y() * scene().picture().height()), PrintableText.escape(note.text()));
            }
        }
        console.out().flush();
        if (!change.notes().isEmpty() || printed.containsKey(change.page())) {
            printed.put(change.page(), change.notes());
        }
    }
}
