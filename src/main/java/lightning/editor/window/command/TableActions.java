package lightning.editor.window.command;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.Sentence;
import lightning.format.picture.CubeReader;
import lightning.render.image.CubeTable;
import lightning.render.image.ViewTransform;

/** The table of colours that the view shows through: chosen by its file, kept from one run to the next. */
public final class TableActions {
    private static final String KEY = "table";

    private final EditorModel model;
    private final FilePrompt prompt;
    private final Notices notices;
    private final Preferences preferences;

    private TableActions(EditorModel model, FilePrompt prompt, Notices notices, Preferences preferences) {
        this.model = model;
        this.prompt = prompt;
        this.notices = notices;
        this.preferences = preferences;
    }

    /** Does the command. */
    static void addTo(EditorModel model, FilePrompt prompt, Notices notices, Preferences preferences) {
        var actions = new TableActions(model, prompt, notices, preferences);
        model.commands().setSwitch(Command.COLOR_TABLE, model.picture().viewProperty().map(view -> view.cube().isPresent()),
                actions::change);
    }

    private void change() {
        ViewTransform view = model.picture().viewProperty().get();
        if (view.cube().isPresent()) {
            keep(Optional.empty());
        } else {
            prompt.table(model.bringer().folder()).ifPresent(file -> model.files()
                    .beside(() -> CubeReader.read(file), table -> {
                        keep(Optional.of(table));
                        model.editor().message().show(Texts.of("Shown through {0}, {1}", Quote.path(file.getFileName()), table.size()));
                    }, why -> notices.failed(Texts.of("The table could not be read"), why)));
        }
    }

    private void keep(Optional<CubeTable> table) {
        show(model, table);
        preferences.set(KEY, table.map(t -> t.file().toAbsolutePath().toString()).orElse(""));
        preferences.save();
    }

    private static void show(EditorModel model, Optional<CubeTable> table) {
        var view = model.picture().viewProperty();
        view.set(view.get().withCube(table));
    }

    /** Whether the view was through a table in the run before. */
    public static boolean isKept(Preferences preferences) {
        return !preferences.is(KEY, "");
    }

    /** Reads the table of the run before, beside the window's thread. */
    public static void restore(EditorModel model, Preferences preferences) {
        if (isKept(preferences)) {
            String kept = preferences.text(KEY, "");
            model.files().beside(() -> CubeReader.read(path(kept)), table -> show(model, Optional.of(table)),
                    why -> model.editor().message().show(Sentence.of(why)));
        }
    }

    private static Path path(String text) {
        try {
            return Path.of(text);
        } catch (InvalidPathException e) {
            // Another system wrote it: there is no such file here.
            return Path.of("table" + CubeReader.ENDING);
        }
    }
}
