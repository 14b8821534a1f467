package lightning.app.command;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import javafx.scene.control.ButtonType;
import lightning.app.model.EditorModel;
import lightning.edit.Command;
import lightning.edit.Consent;
import lightning.edit.TextDifference;
import lightning.file.ChangedFileException;
import lightning.file.ReadOnlyFileException;

/** Saves the scene, and asks where something would be lost that the artist does not know of. */
final class SceneSaver {
    /** As much of another's text as any scene has. */
    private static final int MOST_BYTES = 64 << 20;

    private final EditorModel model;
    private final FilePrompt prompt;
    private final Notices notices;
    private final Runnable saved;

    /** @param saved hears that the scene was written */
    SceneSaver(EditorModel model, FilePrompt prompt, Notices notices, Runnable saved) {
        this.model = model;
        this.prompt = prompt;
        this.notices = notices;
        this.saved = saved;
    }

    /** Saves to the document's file; returns whether the scene was written, there or where the artist chose instead. */
    boolean save() {
        return write(model.document().file(), Set.of());
    }

    /** Asks where to; returns whether the scene was written. */
    boolean saveAs() {
        Optional<Path> chosen = prompt.sceneToWrite(model.document().file());
        if (chosen.isEmpty()) {
            return false;
        }
        Path file = withEnding(chosen.get());
        // The system asked about the name that was typed, not about this one.
        boolean replaces = !file.equals(chosen.get()) && Files.exists(file);
        return (!replaces || notices.mayReplace(file)) && write(file, Set.of());
    }

    private static Path withEnding(Path file) {
        String name = file.getFileName().toString();
        return name.endsWith(".jen") ? file : file.resolveSibling(name + ".jen");
    }

    private boolean write(Path file, Set<Consent> allowed) {
        try {
            model.workbench().saveAs(file, allowed);
            saved.run();
            return true;
        } catch (ChangedFileException e) {
            return askAboutBoth(allowed);
        } catch (ReadOnlyFileException e) {
            ButtonType answer = notices.readOnly(file).orElse(ButtonType.CANCEL);
            return answer == Notices.REPLACE ? write(file, with(allowed, Consent.REPLACE_READ_ONLY))
                    : answer == Notices.SAVE_AS && saveAs();
        } catch (IOException e) {
            notices.failed("The scene could not be saved", e);
            return false;
        }
    }

    /** Shows the open scene beside what the file holds by now, and does what the artist then wants; returns whether it was saved. */
    boolean askAboutBoth() {
        return askAboutBoth(Set.of());
    }

    private boolean askAboutBoth(Set<Consent> allowed) {
        Path file = model.document().file();
        DifferenceList both;
        try {
            both = new DifferenceList(TextDifference.rows(model.document().document().text(), text(file)));
        } catch (IOException e) {
            notices.failed(model.document().name() + " could not be read", e);
            return false;
        }
        ButtonType answer = notices.changed(model.document().name(), both).orElse(ButtonType.CANCEL);
        if (answer == Notices.OVERWRITE) {
            return write(file, with(allowed, Consent.OVERWRITE_CHANGED));
        }
        if (answer == Notices.RELOAD) {
            model.run(Command.RELOAD);
        }
        return answer == Notices.SAVE_AS && saveAs();
    }

    private static Set<Consent> with(Set<Consent> allowed, Consent more) {
        Set<Consent> all = EnumSet.of(more);
        all.addAll(allowed);
        return all;
    }

    private static String text(Path file) throws IOException {
        if (!Files.isRegularFile(file)) {
            return "";
        }
        try (InputStream in = Files.newInputStream(file)) {
            return new String(in.readNBytes(MOST_BYTES), StandardCharsets.UTF_8);
        }
    }
}
