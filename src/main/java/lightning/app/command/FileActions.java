package lightning.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import javafx.scene.control.ButtonType;
import javafx.scene.control.MenuItem;
import lightning.app.model.EditorModel;
import lightning.app.model.Preferences;
import lightning.edit.Command;
import lightning.edit.OpenDocument;
import lightning.edit.loop.Frame;
import lightning.image.PictureFile;
import lightning.image.ViewTransform;
import lightning.jen.JenException;
import lightning.text.Quote;

/** The commands about files. Files are read and pictures written on a thread of their own. */
public final class FileActions implements AutoCloseable {
    private final EditorModel model;
    private final FilePrompt prompt;
    private final Notices notices;
    private final Preferences preferences;
    private final Runnable quit;
    private final SceneSaver saver;
    private final ExecutorService thread = Executors.newSingleThreadExecutor(task -> {
        Thread t = new Thread(task, "lightning-files");
        t.setDaemon(true);
        return t;
    });

    /** @param quit closes the window, which then asks about unsaved edits */
    public FileActions(EditorModel model, FilePrompt prompt, Notices notices, Preferences preferences, Runnable quit) {
        this.model = model;
        this.prompt = prompt;
        this.notices = notices;
        this.preferences = preferences;
        this.quit = quit;
        saver = new SceneSaver(model, prompt, notices, this::saved);
        model.setAction(Command.LOAD_FILE, () -> prompt.scene(model.document().file().toAbsolutePath().getParent()).ifPresent(this::load));
        model.setAction(Command.RELOAD, this::reload);
        model.setAction(Command.SAVE_SCENE, saver::save);
        model.setAction(Command.SAVE_SCENE_AS, saver::saveAs);
        model.setAction(Command.SAVE_IMAGE, this::saveImage);
    }

    /** Opens a scene; the open one stays where it cannot be read. Asks about unsaved edits first. */
    public void load(Path file) {
        if (!mayLeave()) {
            return;
        }
        model.say("Reading " + file.getFileName() + " …");
        thread.execute(() -> {
            try {
                OpenDocument opened = OpenDocument.open(file);
                model.window().execute(() -> {
                    model.say("");
                    model.open(opened);
                    preferences.opened(file);
                });
            } catch (IOException | JenException | RuntimeException e) {
                model.window().execute(() -> {
                    model.say("");
                    notices.failed(Quote.path(file.getFileName()) + " could not be opened", e);
                });
            }
        });
    }

    /** Whether the open document may be left: it is saved, or the artist does not want it. */
    public boolean mayLeave() {
        if (!model.document().isDirty()) {
            return true;
        }
        ButtonType answer = notices.unsaved(model.document().name()).orElse(ButtonType.CANCEL);
        return answer == Notices.DISCARD || answer == Notices.SAVE && saver.save();
    }

    private void reload() {
        try {
            model.workbench().reload();
            model.say("Reloaded; Undo brings the edits back");
        } catch (IOException | JenException e) {
            notices.failed(model.document().name() + " could not be reloaded", e);
        }
    }

    /** Shows the open scene beside its file, which somebody else changed, and asks which it shall be. */
    public void compareWithDisk() {
        saver.askAboutBoth();
    }

    private void saved() {
        preferences.opened(model.document().file());
        model.say("Saved " + model.document().name());
    }

    private void saveImage() {
        var remark = model.situationProperty().get().pendingRemark();
        if (remark.isPresent()) {
            ButtonType answer = notices.pending(remark.get()).orElse(ButtonType.CANCEL);
            if (answer == Notices.GO_FIRST) {
                model.run(Command.GO);
            }
            if (answer != Notices.SAVE_AS_IT_IS) {
                return;
            }
        }
        Path scene = model.document().file();
        String name = model.document().name().replaceFirst("\\.jen$", "") + ".png";
        Frame frame = model.frame();
        prompt.pictureToWrite(scene.resolveSibling(name)).flatMap(this::asPicture).ifPresent(file -> write(file, frame));
    }

    private void write(Path file, Frame frame) {
        ViewTransform view = model.viewProperty().get();
        thread.execute(() -> {
            try {
                PictureFile.write(file, frame.film(), view);
                model.window().execute(() -> model.say("Saved " + Quote.path(file.getFileName())));
            } catch (IOException | RuntimeException e) {
                model.window().execute(() -> notices.failed("The picture could not be saved", e));
            }
        });
    }

    /** A name without an ending becomes a PNG's, about which the system did not ask. */
    private Optional<Path> asPicture(Path chosen) {
        String name = chosen.getFileName().toString();
        if (name.contains(".")) {
            return Optional.of(chosen);
        }
        Path file = chosen.resolveSibling(name + ".png");
        return Files.exists(file) && !notices.mayReplace(file) ? Optional.empty() : Optional.of(file);
    }

    /** One for each scene opened before that is still there. */
    public List<MenuItem> recentItems() {
        List<MenuItem> items = preferences.recent().stream().filter(Files::isRegularFile).map(file -> {
            var item = new MenuItem(Quote.path(file));
            item.setMnemonicParsing(false);
            item.setOnAction(_ -> load(file));
            return item;
        }).toList();
        if (items.isEmpty()) {
            var none = new MenuItem("None yet");
            none.setDisable(true);
            return List.of(none);
        }
        return items;
    }

    public void quit() {
        quit.run();
    }

    @Override
    public void close() {
        thread.shutdown();
    }
}
