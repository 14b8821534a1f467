package lightning.editor.window.command;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javafx.collections.FXCollections;
import javafx.collections.ObservableList;
import javafx.scene.control.ButtonType;
import javafx.scene.control.MenuItem;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.document.FileThread;
import lightning.document.NewScene;
import lightning.document.OpenDocument;
import lightning.document.PictureArea;
import lightning.document.RecoveryFolder;
import lightning.document.imports.ImportPreviews;
import lightning.document.loop.Frame;
import lightning.editor.Command;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.StatusMessage;
import lightning.format.exchange.ImportLighting;
import lightning.format.exchange.ImportOptions;
import lightning.format.exchange.SceneImporter;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.format.jen.JenFile;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;

/** Actions of the file commands. Files are read and written in the background. */
public final class FileActions {
    /** Longer side of the previews for choosing the lighting of an imported scene, pixels. */
    private static final int IMPORT_PICTURE_SIZE = 280;

    private final EditorModel model;
    private final SceneEditor editor;
    private final StatusMessage message;
    private final FilePrompt prompt;
    private final EditorDialogs notices;
    private final Preferences preferences;
    private final SceneSaver saver;
    private final PictureExport export;
    private final ReviewActions reviews;
    private final ObservableList<Path> recent = FXCollections.observableArrayList();

    /** @param quit  closes the window, which then shows a dialog for unsaved edits */
    public FileActions(EditorModel model, FilePrompt prompt, EditorDialogs notices, Preferences preferences, Runnable quit) {
        this.model = model;
        editor = model.editor();
        message = editor.message();
        this.prompt = prompt;
        model.fileImporter().setFilePrompt((title, kind) -> prompt.assetToOpen(title, kind, model.fileImporter().folder()));
        this.notices = notices;
        this.preferences = preferences;
        export = new PictureExport(model, prompt, notices);
        reviews = new ReviewActions(model, prompt, notices);
        saver = new SceneSaver(model, prompt, notices, this::afterSave);
        model.commands().setAction(Command.NEW_SCENE, this::newScene);
        model.commands().setAction(Command.LOAD_FILE,
                () -> prompt.sceneToOpen(folderToOpen()).ifPresent(this::load));
        model.commands().setAction(Command.RELOAD, this::reload);
        model.commands().setAction(Command.RECOVER, this::findRecoveries);
        model.commands().setAction(Command.SAVE_SCENE, () -> saver.save(() -> {}));
        model.commands().setAction(Command.SAVE_SCENE_AS, () -> saver.saveAs(() -> {}));
        model.commands().setAction(Command.SAVE_IMAGE, this::saveImage);
        model.commands().setAction(Command.QUIT, quit);
        RigActions.register(model.commands(), editor, model.files(), prompt, notices);
        ColorTableActions.register(model, prompt, notices, preferences);
        OcioActions.register(model, prompt, notices, preferences);
        refreshRecent();
    }

    /** Opens or imports a scene file. Asks about unsaved edits first; the open scene stays until the file is read, and if that fails. */
    public void load(Path file) {
        confirmClose(() -> openOrImport(file));
    }

    /** Returns the folder of the open scene; of the last one, or the user's, if the open scene has no file of its own. */
    private Path folderToOpen() {
        return !editor.document().isUntitled() ? model.fileImporter().folder()
                : preferences.recent().stream().map(Path::getParent).filter(Files::isDirectory).findFirst()
                        .orElseGet(() -> editor.document().proposedFile("").toAbsolutePath());
    }

    /** Opens a new scene without a file, at the size of its pane. */
    private void newScene() {
        PictureArea area = model.layout().pictureArea();
        confirmClose(() -> read(NewScene.placeholder(), () -> NewScene.create(area)));
    }

    /** Opens a copy of a scene at the size of its pane. Asks about unsaved edits first. */
    public void openCopy(Path file) {
        PictureArea area = model.layout().pictureArea();
        confirmClose(() -> read(file, () -> OpenDocument.openCopy(file).fittedTo(area)));
    }

    private void openOrImport(Path file) {
        if (SceneImporter.isImportName(file.getFileName().toString())) {
            importScene(file);
        } else {
            read(file, () -> OpenDocument.open(file));
        }
    }

    /** Converts a file of another format to a scene next to it and opens that. Prompts for another place if the scene exists. */
    private void importScene(Path file) {
        String name = file.getFileName().toString();
        Path proposal = file.resolveSibling(name.substring(0, name.lastIndexOf('.')) + JenFile.EXTENSION);
        model.files().runConcurrently(() -> Files.exists(proposal), exists -> {
            if (!exists) {
                importScene(file, proposal);
            } else {
                prompt.sceneToWrite(proposal).ifPresent(
                        chosen -> notices.withExtension(model.files(), chosen, JenFile.EXTENSION, to -> importScene(file, to)));
            }
        }, failure -> notices.showFailure(Messages.tr("{0} could not be imported", Quote.path(file.getFileName())), failure));
    }

    /** Imported scene with a preview of each choice. */
    private record ImportPreview(ImportedScene imported, ImportPreviews pictures) {}

    private void importScene(Path file, Path to) {
        readInBackground(file, () -> {
            var progress = new FileProgressMessage(file, model.fileActivity(), model.files().windowExecutor(), message);
            ImportedScene imported = SceneImporter.read(file, to, ImportOptions.DEFAULT, progress).withIndirect();
            return new ImportPreview(imported, new ImportPreviews(imported, IMPORT_PICTURE_SIZE));
        }, preview -> {
            // Clears the progress message.
            message.clear();
            var closed = new AtomicBoolean();
            Optional<ImportPreviews.Choice> chosen =
                    notices.askImport(file, preview.pictures(), cards -> showPreviews(preview.pictures(), cards, closed::get));
            closed.set(true);
            chosen.ifPresent(choice -> write(file, preview, choice));
        });
    }

    /** Renders the previews in the background, and shows each when it is ready. */
    private void showPreviews(ImportPreviews previews, ImportChooser cards, BooleanSupplier closed) {
        DedicatedThread.create("lightning-previews", () -> {
            try (var workers = new WorkerPool(WorkerPool.processorCount())) {
                for (ImportPreviews.Choice choice : previews.choices()) {
                    ImportPreviews.Preview preview = previews.render(choice, workers, Progress.cancellation(closed));
                    boolean isUseful = previews.isUseful(choice);
                    model.files().windowExecutor().execute(() -> {
                        cards.show(choice, preview);
                        if (!isUseful) {
                            cards.remove(choice);
                        }
                    });
                }
            } catch (CancellationException e) {
                // The choice was made.
            } catch (RuntimeException | OutOfMemoryError e) {
                // Writing the chosen scene reports it.
            }
        }).start();
    }

    private void write(Path file, ImportPreview preview, ImportPreviews.Choice choice) {
        PictureArea area = model.layout().pictureArea();
        read(file, () -> {
            ImportedScene exposed = choice.apply(preview.imported()).withExposure(exposure(preview.pictures(), choice));
            // Without a camera, the file has no size of its own either.
            ImportedScene imported = exposed.subject().hasCamera() ? exposed
                    : exposed.withPicture(area.fit(exposed.unscaledScene().picture()));
            imported.write();
            int noteCount = imported.notes().size();
            String text = Messages.tr("Imported {0}", Quote.path(file.getFileName())) + (noteCount == 0 ? "" : Messages.count(noteCount,
                    "; {0} import note: {1}", "; {0} import notes: {1}",
                    noteCount, String.join(", ", imported.notes().keySet().stream().sorted().toList())));
            model.files().windowExecutor().execute(() -> {
                message.show(text);
                if (noteCount > 0) {
                    notices.showImportNotes(file, imported.notes());
                }
            });
            return OpenDocument.open(imported.sceneFile());
        });
    }

    /** Returns the exposure that the lights of a choice need, in stops. */
    private static double exposure(ImportPreviews previews, ImportPreviews.Choice choice) {
        if (choice.lighting() != ImportLighting.FILE) {
            return 0;
        }
        try (var workers = new WorkerPool(WorkerPool.processorCount())) {
            return previews.render(choice, workers, Progress.NONE).exposure();
        }
    }

    private void read(Path file, FileThread.FileTask<OpenDocument> task) {
        Scene editedScene = editor.document().scene();
        readInBackground(file, task, opened -> {
            if (editor.document().scene() == editedScene) {
                showDocument(opened);
            } else {
                // Edited while the file was read.
                confirmClose(() -> showDocument(opened));
            }
        });
    }

    private <T> void readInBackground(Path file, FileThread.FileTask<T> task, Consumer<T> onRead) {
        // The message belongs to the open scene.
        message.clear();
        model.fileActivity().beginReading(file);
        model.files().runConcurrently(task, read -> runIfActive(file, () -> onRead.accept(read)),
                failure -> runIfActive(file, () -> {
                    message.clear();
                    notices.showFailure(Messages.tr("{0} could not be opened", Quote.path(file.getFileName())), failure);
                }));
    }

    private void runIfActive(Path file, Runnable action) {
        if (model.fileActivity().end(file)) {
            action.run();
        }
    }

    private void showDocument(OpenDocument opened) {
        model.open(opened);
        if (!opened.isUntitled()) {
            preferences.addRecent(opened.file());
        }
        refreshRecent();
        showNotes();
    }

    /** Shows which files of the open scene cannot be used; nothing if there are none. */
    public void showNotes() {
        OpenDocument document = editor.document();
        if (!document.notes().isEmpty()) {
            model.files().runConcurrently(document::missingFiles, missing -> showNotes(document, missing),
                    _ -> showNotes(document, List.of()));
        }
    }

    private void showNotes(OpenDocument document, List<String> missing) {
        if (document == editor.document()) {
            notices.showNotes(document.file(), document.notes(),
                    missing.isEmpty() ? Optional.empty() : Optional.of(() -> locate(document, missing.getFirst())));
        }
    }

    /** Prompts for a missing file, copies it and its neighbors that are missing too, and opens the scene again. */
    private void locate(OpenDocument document, String missing) {
        if (document != editor.document()) {
            // Another scene was opened while the list was shown.
            return;
        }
        prompt.missingFileToOpen(missing, model.fileImporter().folder()).ifPresent(
                chosen -> confirmClose(() -> read(document.file(), () -> document.withMissingFiles(missing, chosen))));
    }

    /** Offers to recover unsaved scenes of crashed processes, all in one dialog; does nothing if there are none. */
    public void offerRecovery(List<RecoveryFolder.RecoverableScene> scenes) {
        if (!scenes.isEmpty()) {
            notices.askRecover(scenes, this::discard).ifPresent(chosen -> confirmClose(() -> recover(chosen)));
        }
    }

    private void findRecoveries() {
        model.files().runConcurrently(model.workbench().recovery()::list, found -> {
            message.show(found.isEmpty() ? Messages.tr("There are no unsaved changes to recover") : "");
            offerRecovery(found);
        }, failure -> notices.showFailure(Messages.tr("The edits could not be recovered"), failure));
    }

    private void discard(RecoveryFolder.RecoverableScene discarded) {
        model.files().runInOrder(() -> {
            discarded.delete();
            return discarded;
        }, _ -> {}, failure -> notices.showFailure(Messages.tr("Could not discard the edits"), failure));
    }

    /** Opens edits recovered after a crash. */
    public void recover(RecoveryFolder.RecoverableScene recoverable) {
        model.files().runConcurrently(() -> OpenDocument.recover(recoverable), recovered -> {
            model.recover(recoverable, recovered);
            message.show(Messages.tr("Recovered: {0}", recovered.history().undoLabel().orElse(Messages.tr("no changes"))));
        },
                failure -> notices.showFailure(Messages.tr("The edits could not be recovered"), failure));
    }

    /** Continues once the open document is saved or the user discards its edits. Waits for a save in progress first. */
    public void confirmClose(Runnable next) {
        if (model.workbench().isSaving()) {
            model.files().runInOrder(() -> null, _ -> confirmClose(next), _ -> {});
        } else if (!editor.document().isDirty()) {
            next.run();
        } else {
            ButtonType answer = notices.askUnsaved(editor.document().title()).orElse(ButtonType.CANCEL);
            if (answer == EditorDialogs.DISCARD) {
                next.run();
            } else if (answer == EditorDialogs.SAVE) {
                saver.save(() -> confirmClose(next));
            }
        }
    }

    private void reload() {
        String name = editor.document().name();
        model.workbench()
                .reload(failure -> failure.ifPresentOrElse(
                        cause -> notices.showFailure(Messages.tr("{0} could not be reloaded", name), cause),
                        () -> message.show(Messages.tr("Reverted to the saved file; Undo restores the edits"))));
    }

    /** Shows the differences between the open scene and its externally changed file, in a dialog to keep one of them. */
    public void compareWithDisk() {
        saver.resolveConflict();
    }

    private void afterSave() {
        preferences.addRecent(editor.document().file());
        refreshRecent();
        message.show(Messages.tr("Saved {0}", editor.document().name()));
    }

    private void saveImage() {
        FinalPicture picture = FinalPicture.of(model);
        var message = model.commands().editorState().get().pendingMessage();
        if (message.isPresent() && picture.isTraced()) {
            ButtonType answer = notices.askPending(message.get()).orElse(ButtonType.CANCEL);
            if (answer == EditorDialogs.GO_FIRST) {
                model.commands().run(Command.GO);
            }
            if (answer != EditorDialogs.SAVE_AS_IT_IS) {
                return;
            }
        }
        String name = JenFile.stem(editor.document().name()) + ImageFormat.PNG.extension();
        prompt.pictureToWrite(editor.document().proposedFile(name)).ifPresent(chosen -> {
            if (chosen.getFileName().toString().contains(".")) {
                write(chosen, picture);
            } else {
                notices.withExtension(model.files(), chosen, ImageFormat.PNG.extension(), file -> write(file, picture));
            }
        });
    }

    private void write(Path file, FinalPicture picture) {
        ViewTransform view = model.picture().outputView();
        if (!picture.isTraced()) {
            new BackgroundExport(model, notices).start(file, Messages.tr("The image could not be saved"),
                    (to, progress) -> picture.write(file, progress, (film, _) -> ImageFile.write(to, film, view)));
            return;
        }
        Frame frame = picture.traced().orElseThrow();
        boolean isDisplayed = ImageFormat.find(file).filter(ImageFormat::isDisplayReferred).isPresent();
        message.show(Messages.tr("Saving {0} …", Quote.path(file.getFileName())));
        OpenDocument document = editor.document();
        model.files().runInOrder(() -> {
            document.inputs().check(file);
            ImageFile.write(file, frame.film(), view);
            return file;
        }, _ -> message.show(
                Messages.tr("Saved {0}{1}", Quote.path(file.getFileName()), isDisplayed && !view.equals(ViewTransform.DEFAULT)
                        ? " (" + view.description() + ")" : "")),
                failure -> {
                    message.clear();
                    notices.showFailure(Messages.tr("The image could not be saved"), failure);
                });
    }

    /** Updates the recent scenes from the preferences, without missing files. */
    private void refreshRecent() {
        List<Path> all = preferences.recent();
        model.files().runConcurrently(() -> all.stream().filter(Files::isRegularFile).toList(), existing -> recent.setAll(existing),
                _ -> {});
    }

    /** Returns a menu item for each export format. */
    public List<MenuItem> exportItems() {
        return Stream.concat(export.items().stream(), reviews.exportItems().stream()).toList();
    }

    /** Returns the recent scenes that existed at the last check, latest first. */
    public ObservableList<Path> recentFiles() {
        return recent;
    }

    /** Returns a menu item for each recent scene that existed at the last check. */
    public List<MenuItem> recentItems() {
        List<MenuItem> items = recent.stream()
                .map(file -> CommandMenuItems.forMenu(model.commands()).value(Command.LOAD_RECENT, Quote.path(file), () -> load(file)))
                .toList();
        return items.isEmpty() ? List.of(CommandMenuItems.placeholder(Command.LOAD_RECENT, Messages.tr("No Recent Scenes"))) : items;
    }
}
