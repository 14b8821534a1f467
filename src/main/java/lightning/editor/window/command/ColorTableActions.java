package lightning.editor.window.command;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.base.file.ParentFolder;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.editor.Command;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.Preferences;
import lightning.format.image.CubeLutReader;
import lightning.format.ocio.OcioReference;
import lightning.format.ocio.OcioView;
import lightning.render.image.CubeLut;
import lightning.render.image.ViewTransform;
import org.jspecify.annotations.Nullable;

/** Command that applies a color lookup table (.cube) to the view. The choice is stored between sessions. */
public final class ColorTableActions {
    private static final String KEY = "table";
    /** Configuration and view of OpenColorIO that the table is made of; empty for a table of a file. */
    private static final String OCIO_CONFIG = "ocio.config";
    private static final String OCIO_VIEW = "ocio.view";
    /** Last chosen ones, also after the table was removed. */
    private static final String LAST_CONFIG = "ocio.last.config";
    private static final String LAST_VIEW = "ocio.last.view";

    private final EditorModel model;
    private final FilePrompt prompt;
    private final EditorDialogs notices;
    private final Preferences preferences;

    private ColorTableActions(EditorModel model, FilePrompt prompt, EditorDialogs notices, Preferences preferences) {
        this.model = model;
        this.prompt = prompt;
        this.notices = notices;
        this.preferences = preferences;
    }

    /** Registers the command. */
    static void register(EditorModel model, FilePrompt prompt, EditorDialogs notices, Preferences preferences) {
        var actions = new ColorTableActions(model, prompt, notices, preferences);
        model.commands().setToggle(Command.COLOR_TABLE, model.picture().viewProperty().map(view -> view.lut().isPresent()),
                actions::toggle);
    }

    private void toggle() {
        ViewTransform view = model.picture().viewProperty().get();
        if (view.lut().isPresent()) {
            setTable(Optional.empty());
        } else {
            prompt.tableToOpen(ParentFolder.of(model.editor().document().proposedFile("lut"))).ifPresent(file -> model.files()
                    .runConcurrently(() -> {
                        List<String> notes = new ArrayList<>();
                        return new Loaded(CubeLutReader.read(file, notes::add), notes);
                    }, loaded -> {
                        setTable(Optional.of(loaded.table()));
                        model.editor().message().show(Stream.concat(Stream.of(Messages.tr("Loaded LUT {0}, {1}",
                                Quote.path(file.getFileName()), loaded.table().sizeText())), loaded.notes().stream())
                                .collect(Collectors.joining("; ")));
                    }, failure -> notices.showFailure(Messages.tr("The LUT could not be read"), failure)));
        }
    }

    private record Loaded(CubeLut table, List<String> notes) {}

    private void setTable(Optional<CubeLut> table) {
        show(model, table);
        store(preferences, table.map(t -> t.file().toAbsolutePath().toString()).orElse(""), new OcioReference("", ""));
    }

    /**
     * Applies the table of a view of OpenColorIO.
     *
     * @param isKept true if the table has a file, which the next session reads; false if it makes the table again
     */
    static void set(EditorModel model, Preferences preferences, CubeLut table, OcioReference view, boolean isKept) {
        show(model, Optional.of(table));
        preferences.set(LAST_CONFIG, view.config());
        preferences.set(LAST_VIEW, view.view());
        store(preferences, isKept ? table.file().toAbsolutePath().toString() : "", isKept ? new OcioReference("", "") : view);
    }

    private static void store(Preferences preferences, String file, OcioReference view) {
        preferences.set(KEY, file);
        preferences.set(OCIO_CONFIG, view.config());
        preferences.set(OCIO_VIEW, view.view());
        preferences.save();
    }

    /**
     * Returns the last chosen view; its configuration may be empty.
     *
     * @param environment configuration of the environment, used if none was chosen; null for none
     */
    static OcioReference lastView(Preferences preferences, @Nullable String environment) {
        String config = preferences.text(LAST_CONFIG, "");
        return new OcioReference(!config.isEmpty() ? config : environment == null ? "" : environment, preferences.text(LAST_VIEW, ""));
    }

    private static void show(EditorModel model, Optional<CubeLut> table) {
        var view = model.picture().viewProperty();
        view.set(view.get().withLut(table));
    }

    /** Returns whether the previous session used a lookup table. */
    public static boolean hasStoredTable(Preferences preferences) {
        return !preferences.hasValue(KEY, "") || !preferences.hasValue(OCIO_CONFIG, "");
    }

    /** Reads the previous session's lookup table in the background and applies it. */
    public static void restore(EditorModel model, Preferences preferences) {
        if (hasStoredTable(preferences)) {
            String storedPath = preferences.text(KEY, "");
            var view = new OcioReference(preferences.text(OCIO_CONFIG, ""), preferences.text(OCIO_VIEW, ""));
            model.files().runConcurrently(() -> view.config().isEmpty() ? CubeLutReader.read(path(storedPath))
                    : OcioView.bake(view, Progress.NONE).table(), table -> show(model, Optional.of(table)),
                    failure -> model.editor().message().show(ErrorMessage.of(failure)));
        }
    }

    private static Path path(String text) {
        try {
            return Path.of(text);
        } catch (InvalidPathException e) {
            // Path of another operating system: use a file that does not exist.
            return Path.of("table" + CubeLutReader.EXTENSION);
        }
    }
}
