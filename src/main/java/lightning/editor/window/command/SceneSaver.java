package lightning.editor.window.command;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Set;
import javafx.scene.control.ButtonType;
import lightning.base.file.ChangedFileException;
import lightning.base.file.ReadOnlyFileException;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.Consent;
import lightning.editor.document.OpenDocument;
import lightning.editor.document.TextDifference;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.StatusMessage;
import lightning.format.jen.JenFile;
import lightning.format.jen.JenLimits;
import lightning.scene.shot.AnimatedScene;

/** Saves the scene, and asks where something would be lost that the artist does not know of. */
final class SceneSaver {
    private final EditorModel model;
    private final SceneEditor editor;
    private final StatusMessage message;
    private final FilePrompt prompt;
    private final Notices notices;
    private final Runnable saved;

    /** @param saved hears that the scene was written */
    SceneSaver(EditorModel model, FilePrompt prompt, Notices notices, Runnable saved) {
        this.model = model;
        editor = model.editor();
        message = editor.message();
        this.prompt = prompt;
        this.notices = notices;
        this.saved = saved;
    }

    /** Saves to the document's file; {@code then} runs when the scene was written, there or where the artist chose instead. */
    void save(Runnable then) {
        write(editor.document().file(), Set.of(), then);
    }

    /** Asks where to; {@code then} runs when the scene was written. */
    void saveAs(Runnable then) {
        prompt.sceneToWrite(editor.document().file()).ifPresent(
                chosen -> notices.withEnding(model.files(), chosen, JenFile.ENDING, file -> write(file, Set.of(), then)));
    }

    private void write(Path file, Set<Consent> allowed, Runnable then) {
        message.show(Texts.of("Saving {0} …", Quote.path(file.getFileName())));
        model.workbench().saveAs(file, allowed, failure -> {
            message.clear();
            failure.ifPresentOrElse(why -> ask(file, allowed, why, then), () -> {
                saved.run();
                then.run();
            });
        });
    }

    private void ask(Path file, Set<Consent> allowed, Throwable why, Runnable then) {
        switch (why) {
            case ChangedFileException _ -> askAboutBoth(allowed, then);
            case ReadOnlyFileException _ -> {
                ButtonType answer = notices.readOnly(file).orElse(ButtonType.CANCEL);
                if (answer == Notices.REPLACE) {
                    write(file, with(allowed, Consent.REPLACE_READ_ONLY), then);
                } else if (answer == Notices.SAVE_AS) {
                    saveAs(then);
                }
            }
            case Throwable other -> notices.failed(Texts.of("The scene could not be saved"), other);
        }
    }

    /** Shows the open scene beside what the file holds by now, and does what the artist then wants. */
    void askAboutBoth() {
        askAboutBoth(Set.of(), () -> {});
    }

    private void askAboutBoth(Set<Consent> allowed, Runnable then) {
        OpenDocument document = editor.document();
        AnimatedScene mine = document.content();
        model.files().beside(() -> TextDifference.rows(document.text(mine), text(document.file())),
                rows -> decide(notices.changed(document.name(), new DifferenceList(rows)).orElse(ButtonType.CANCEL), allowed, then),
                why -> notices.failed(Texts.of("{0} could not be read", document.name()), why));
    }

    private void decide(ButtonType answer, Set<Consent> allowed, Runnable then) {
        if (answer == Notices.OVERWRITE) {
            write(editor.document().file(), with(allowed, Consent.OVERWRITE_CHANGED), then);
        } else if (answer == Notices.RELOAD) {
            model.commands().run(Command.RELOAD);
        } else if (answer == Notices.SAVE_AS) {
            saveAs(then);
        }
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
            return new String(in.readNBytes(JenLimits.FILE_BYTES), StandardCharsets.UTF_8);
        }
    }
}
