package lightning.editor.window.command;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import javafx.scene.control.ButtonType;
import javafx.scene.control.MenuItem;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.base.work.Workers;
import lightning.editor.document.Command;
import lightning.editor.document.FileThread;
import lightning.editor.document.NewScene;
import lightning.editor.document.OpenDocument;
import lightning.editor.document.Recovery;
import lightning.editor.loop.Frame;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.StatusMessage;
import lightning.format.MeshFormat;
import lightning.format.exchange.Import;
import lightning.format.exchange.Importer;
import lightning.format.exchange.LightUnits;
import lightning.format.exchange.UnitPictures;
import lightning.format.jen.JenFile;
import lightning.format.picture.PictureFile;
import lightning.format.picture.PictureFormat;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;

/** The commands about files. Files are read and written beside the window's thread. */
public final class FileActions {
    /** Of the pictures that ask for units; pixels of the longer side. */
    private static final int PICTURE_SIZE = 280;

    private final EditorModel model;
    private final SceneEditor editor;
    private final StatusMessage message;
    private final FilePrompt prompt;
    private final Notices notices;
    private final Preferences preferences;
    private final SceneSaver saver;
    private final PictureExport export;
    private List<Path> recent = List.of();

    /** @param quit closes the window, which then asks about unsaved edits */
    public FileActions(EditorModel model, FilePrompt prompt, Notices notices, Preferences preferences, Runnable quit) {
        this.model = model;
        editor = model.editor();
        message = editor.message();
        this.prompt = prompt;
        model.bringer().setBrowse((title, kind) -> prompt.beside(title, kind, model.bringer().folder()));
        this.notices = notices;
        this.preferences = preferences;
        export = new PictureExport(model, prompt, notices);
        saver = new SceneSaver(model, prompt, notices, this::saved);
        model.commands().setAction(Command.NEW_SCENE, this::begin);
        model.commands().setAction(Command.LOAD_FILE,
                () -> prompt.scene(model.bringer().folder()).ifPresent(this::load));
        model.commands().setAction(Command.RELOAD, this::reload);
        model.commands().setAction(Command.SAVE_SCENE, () -> saver.save(() -> {}));
        model.commands().setAction(Command.SAVE_SCENE_AS, () -> saver.saveAs(() -> {}));
        model.commands().setAction(Command.SAVE_IMAGE, this::saveImage);
        model.commands().setAction(Command.QUIT, quit);
        RigActions.addTo(model.commands(), editor, model.files(), prompt, notices);
        TableActions.addTo(model, prompt, notices, preferences);
        listRecent();
    }

    /** Opens a scene; the open one stays where it cannot be read, and until it is read. Asks about unsaved edits first. */
    public void load(Path file) {
        leave(() -> read(file));
    }

    /** Asks where, and begins a scene there; one that was there was asked about by the dialog. */
    private void begin() {
        prompt.sceneToWrite(editor.document().file().resolveSibling("untitled" + JenFile.ENDING))
                .ifPresent(chosen -> notices.withEnding(model.files(), chosen, JenFile.ENDING, this::begin));
    }

    private void begin(Path file) {
        leave(() -> read(file, () -> {
            NewScene.write(file);
            return OpenDocument.open(file);
        }));
    }

    private void read(Path file) {
        if (MeshFormat.isNamedSo(file.getFileName().toString())) {
            bringIn(file);
        } else {
            read(file, () -> OpenDocument.open(file));
        }
    }

    /** Makes a scene beside a file of another program and opens it; asks where if one is there already. */
    private void bringIn(Path file) {
        String name = file.getFileName().toString();
        Path proposal = file.resolveSibling(name.substring(0, name.lastIndexOf('.')) + JenFile.ENDING);
        model.files().beside(() -> Files.exists(proposal), there -> {
            if (!there) {
                bringIn(file, proposal);
            } else {
                prompt.sceneToWrite(proposal).ifPresent(
                        chosen -> notices.withEnding(model.files(), chosen, JenFile.ENDING, to -> bringIn(file, to)));
            }
        }, why -> notices.failed(Texts.of("{0} could not be imported", Quote.path(file.getFileName())), why));
    }

    /** What was read of a file of another program, and what it looks like in all units, where it does not say which are right. */
    private record Brought(Import made, Map<LightUnits, Film> pictures) {}

    private void bringIn(Path file, Path to) {
        reading(file, () -> {
            var progress = new ReadingLine(file, model.fileWork(), model.files().window(), message);
            Import made = Importer.read(file, to, LightUnits.CANDELA, progress);
            try (var workers = new Workers(Workers.available())) {
                return new Brought(made, UnitPictures.of(made, PICTURE_SIZE, workers, progress.silent()));
            }
        }, brought -> {
            if (brought.pictures().isEmpty()) {
                write(file, brought.made());
            } else {
                // The line says no longer that it is read.
                message.clear();
                notices.lightUnits(file, brought.pictures()).ifPresent(units -> write(file, brought.made().in(units)));
            }
        });
    }

    private void write(Path file, Import made) {
        read(file, () -> {
            made.write();
            int kinds = made.notes().size();
            String told = Texts.of("Imported {0}", Quote.path(file.getFileName())) + (kinds == 0 ? "" : Texts.count(kinds,
                    "; {0} kind of thing is left out or not the same: {1}", "; {0} kinds of things are left out or not the same: {1}",
                    kinds, String.join(", ", made.notes().keySet().stream().sorted().toList())));
            model.files().window().execute(() -> message.show(told));
            return OpenDocument.open(made.to());
        });
    }

    private void read(Path file, FileThread.Work<OpenDocument> work) {
        Scene left = editor.document().scene();
        reading(file, work, opened -> {
            if (editor.document().scene() == left) {
                open(opened);
            } else {
                // It was edited while the other was read.
                leave(() -> open(opened));
            }
        });
    }

    private <T> void reading(Path file, FileThread.Work<T> work, Consumer<T> then) {
        model.fileWork().read(file);
        model.files().beside(work, read -> whileWanted(file, () -> then.accept(read)),
                why -> whileWanted(file, () -> {
                    message.clear();
                    notices.failed(Texts.of("{0} could not be opened", Quote.path(file.getFileName())), why);
                }));
    }

    private void whileWanted(Path file, Runnable then) {
        if (model.fileWork().end(file)) {
            then.run();
        }
    }

    private void open(OpenDocument opened) {
        model.open(opened);
        preferences.opened(opened.file());
        listRecent();
    }

    /** Opens what a crash left unsaved, which is deleted where the artist does not want it. */
    public void recover(Recovery.Found found) {
        model.files().beside(() -> OpenDocument.recover(found), recovered -> model.recover(found, recovered),
                why -> notices.failed(Texts.of("The edits could not be recovered"), why));
    }

    /**
     * Goes on when the open document may be left: it is saved, or the artist does not want it. What is being saved is written
     * first.
     */
    public void leave(Runnable then) {
        if (model.workbench().isSaving()) {
            model.files().inTurn(() -> null, _ -> leave(then), _ -> {});
        } else if (!editor.document().isDirty()) {
            then.run();
        } else {
            ButtonType answer = notices.unsaved(editor.document().name()).orElse(ButtonType.CANCEL);
            if (answer == Notices.DISCARD) {
                then.run();
            } else if (answer == Notices.SAVE) {
                saver.save(() -> leave(then));
            }
        }
    }

    private void reload() {
        String name = editor.document().name();
        model.workbench().reload(failure -> failure.ifPresentOrElse(why -> notices.failed(Texts.of("{0} could not be reloaded", name), why),
                () -> message.show(Texts.of("Reloaded; Undo brings the edits back"))));
    }

    /** Shows the open scene beside its file, which somebody else changed, and asks which it shall be. */
    public void compareWithDisk() {
        saver.askAboutBoth();
    }

    private void saved() {
        preferences.opened(editor.document().file());
        listRecent();
        message.show(Texts.of("Saved {0}", editor.document().name()));
    }

    private void saveImage() {
        var remark = model.commands().situation().get().pendingRemark();
        if (remark.isPresent()) {
            ButtonType answer = notices.pending(remark.get()).orElse(ButtonType.CANCEL);
            if (answer == Notices.GO_FIRST) {
                model.commands().run(Command.GO);
            }
            if (answer != Notices.SAVE_AS_IT_IS) {
                return;
            }
        }
        Path scene = editor.document().file();
        String name = JenFile.stem(editor.document().name()) + PictureFormat.PNG.ending();
        Frame frame = model.picture().frame();
        prompt.pictureToWrite(scene.resolveSibling(name)).ifPresent(chosen -> {
            if (chosen.getFileName().toString().contains(".")) {
                write(chosen, frame);
            } else {
                notices.withEnding(model.files(), chosen, PictureFormat.PNG.ending(), file -> write(file, frame));
            }
        });
    }

    private void write(Path file, Frame frame) {
        ViewTransform view = model.picture().viewProperty().get().ofPicture();
        boolean displayed = PictureFormat.find(file).filter(PictureFormat::isDisplayed).isPresent();
        message.show(Texts.of("Saving {0} …", Quote.path(file.getFileName())));
        model.files().inTurn(() -> {
            PictureFile.write(file, frame.film(), view);
            return file;
        }, _ -> message.show(
                Texts.of("Saved {0}{1}", Quote.path(file.getFileName()), displayed && !view.equals(ViewTransform.DEFAULT)
                        ? " (" + view.text() + ")" : "")),
                why -> {
                    message.clear();
                    notices.failed(Texts.of("The picture could not be saved"), why);
                });
    }

    /** Which of the scenes opened before are still there. */
    private void listRecent() {
        List<Path> all = preferences.recent();
        model.files().beside(() -> all.stream().filter(Files::isRegularFile).toList(), there -> recent = there, _ -> {});
    }

    /** One for each kind of file that the picture can be exported as. */
    public List<MenuItem> exportItems() {
        return export.items();
    }

    /** One for each scene opened before that is still there, as was seen last. */
    public List<MenuItem> recentItems() {
        List<MenuItem> items = recent.stream()
                .map(file -> CommandItems.of(model.commands()).value(Command.LOAD_RECENT, Quote.path(file), () -> load(file))).toList();
        return items.isEmpty() ? List.of(CommandItems.nothing(Command.LOAD_RECENT, Texts.of("None yet"))) : items;
    }
}
