package lightning.editor.window.sequence;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.animation.PauseTransition;
import javafx.util.Duration;
import lightning.base.file.AtomicFile;
import lightning.base.file.ChangedFileException;
import lightning.base.file.FileState;
import lightning.base.file.ParentFolder;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.FileThread;
import lightning.editor.window.model.ErrorMessage;
import lightning.format.jen.JenException;
import lightning.format.jen.JenFile;
import lightning.format.sequence.LoadedSequence;
import lightning.format.sequence.Sequence;
import org.jspecify.annotations.Nullable;

/**
 * The open sequence and its file. Changes are saved a second after the last one; a file that another program changed is not overwritten. Confined to
 * the window's thread.
 */
final class SequenceFile {
    private static final Duration AUTOSAVE = Duration.seconds(1);

    private final FileThread files;
    private final Listener listener;
    private final PauseTransition autosave = new PauseTransition(AUTOSAVE);
    private @Nullable LoadedSequence loaded;
    private boolean isChanged;
    /** File as it was read or last saved; used by the thread of files only. */
    private FileState known = FileState.MISSING;

    /** Observer of the file. */
    interface Listener {
        /** Receives a sequence that was opened. */
        void opened(LoadedSequence sequence);

        /** Runs after the title has changed. */
        void titleChanged();

        /** Receives a sentence about what could not be done. */
        void failed(String message);
    }

    SequenceFile(FileThread files, Listener listener) {
        this.files = files;
        this.listener = listener;
        autosave.setOnFinished(_ -> save());
    }

    /** Returns the open sequence with all changes; null if none is open. */
    @Nullable
    LoadedSequence loaded() {
        return loaded;
    }

    /** Returns the name of the file, with a star if changes are not saved. */
    String title() {
        return loaded == null ? "" : Quote.path(loaded.file().getFileName()) + (isChanged ? " *" : "");
    }

    /** Opens a sequence; the one that is open stays if it cannot be read. */
    void open(Path file) {
        save();
        run(file, () -> read(file), this::show);
    }

    /** Writes a sequence whose rig and only shot are a scene, and opens it. */
    void create(Path file, Path scene) {
        save();
        String name = relative(file, scene);
        var sequence = new Sequence(name, false, List.of(new Sequence.Entry(stem(scene), name, Optional.empty(), List.of(), "")),
                new LinkedHashMap<>());
        run(file, () -> {
            sequence.write(AtomicFile.of(file));
            return read(file);
        }, this::show);
    }

    /** Adds a scene as a shot. */
    void add(Path scene) {
        LoadedSequence open = loaded;
        if (open == null) {
            return;
        }
        String name = stem(scene);
        for (int i = 2; open.sequence().shot(name).isPresent(); i++) {
            name = stem(scene) + " " + i;
        }
        List<Sequence.Entry> shots = new ArrayList<>(open.sequence().shots());
        shots.add(new Sequence.Entry(name, relative(open.file(), scene), Optional.empty(), List.of(), ""));
        var extended = new Sequence(open.sequence().rig(), open.sequence().sharesWorld(), shots, open.sequence().lightNotes());
        run(open.file(), () -> {
            extended.write(AtomicFile.of(open.file()).ifUnchanged(known));
            return read(open.file());
        }, this::show);
    }

    /** Changes values or notes of the open sequence. */
    void change(Sequence sequence) {
        if (loaded != null) {
            loaded = loaded.withSequence(sequence);
            isChanged = true;
            listener.titleChanged();
            autosave.playFromStart();
        }
    }

    /** Saves changes that are not saved yet. */
    void save() {
        autosave.stop();
        LoadedSequence open = loaded;
        if (open == null || !isChanged) {
            return;
        }
        run(open.file(), () -> {
            known = open.sequence().write(AtomicFile.of(open.file()).ifUnchanged(known));
            return open;
        }, _ -> listener.titleChanged());
        isChanged = false;
    }

    private LoadedSequence read(Path file) throws IOException, JenException {
        FileState state = FileState.of(file);
        LoadedSequence sequence = LoadedSequence.read(file);
        known = state;
        return sequence;
    }

    private void run(Path file, FileThread.FileTask<LoadedSequence> task, Consumer<LoadedSequence> onDone) {
        boolean hadChanges = isChanged;
        files.runInOrder(task, onDone, failure -> {
            isChanged |= hadChanges;
            listener.titleChanged();
            listener.failed(failure instanceof ChangedFileException
                    ? Messages.tr("{0} was changed by another program; open it again", Quote.path(file.getFileName()))
                    : ErrorMessage.of(failure));
        });
    }

    private void show(LoadedSequence sequence) {
        loaded = sequence;
        isChanged = false;
        listener.opened(sequence);
        listener.titleChanged();
    }

    private static String stem(Path scene) {
        return JenFile.stem(scene.getFileName().toString());
    }

    private static String relative(Path file, Path scene) {
        Path folder = ParentFolder.of(file.toAbsolutePath().normalize());
        Path target = scene.toAbsolutePath().normalize();
        return folder.getRoot() != null && folder.getRoot().equals(target.getRoot())
                ? folder.relativize(target).toString().replace('\\', '/')
                : target.toString();
    }
}
