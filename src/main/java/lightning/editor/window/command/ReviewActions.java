package lightning.editor.window.command;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.scene.control.MenuItem;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.editor.document.Command;
import lightning.editor.document.EditOutcome;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.StatusMessage;
import lightning.format.jen.JenFile;
import lightning.format.review.Review;
import lightning.format.review.ReviewPage;
import lightning.format.review.ReviewReader;
import lightning.format.review.ReviewedScene;
import lightning.render.cache.PixelCache;
import lightning.render.image.ViewTransform;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Scene;

/** Writes the review page of the picture, and opens what a reviewer saved in it: one edit, and a window with the notes. */
final class ReviewActions {
    private static final String PAGE = ".html";

    private final EditorModel model;
    private final StatusMessage message;
    private final FilePrompt prompt;
    private final EditorDialogs notices;

    ReviewActions(EditorModel model, FilePrompt prompt, EditorDialogs notices) {
        this.model = model;
        message = model.editor().message();
        this.prompt = prompt;
        this.notices = notices;
        model.commands().setAction(Command.OPEN_REVIEW, this::promptAndOpen);
    }

    /** Returns the menu item that writes a page. */
    MenuItem exportItem() {
        return CommandMenuItems.forMenu(model.commands()).updatingValue(Command.EXPORT, Messages.tr("Review Page…"), this::promptAndExport);
    }

    private void promptAndExport() {
        prompt.pageToWrite(model.editor().document().proposedFile(JenFile.stem(model.editor().document().name()) + PAGE))
                .ifPresent(chosen -> notices.withExtension(model.files(), chosen, PAGE, this::export));
    }

    private void export(Path file) {
        PixelCache cache = model.workbench().cache().orElse(null);
        if (model.fileActivity().file() != null || cache == null) {
            message.show(Messages.tr("Wait until the file is loaded and rendering has started"));
            return;
        }
        ViewTransform view = model.picture().outputView();
        message.show(Messages.tr("Writing {0}, about {1} MB", Quote.path(file.getFileName()),
                Math.max(1, Math.round(ReviewPage.estimatedBytes(cache.scene()) / 1e6))));
        String title = model.editor().document().name();
        new BackgroundExport(model, notices).start(file, Messages.tr("The page could not be written"),
                (to, progress) -> ReviewPage.write(to, title, cache, RenderOptions.DEFAULT, view, progress));
    }

    private void promptAndOpen() {
        prompt.reviewToOpen(model.fileImporter().folder()).ifPresent(file -> model.files().runConcurrently(() -> ReviewReader.read(file),
                review -> apply(file, review), failure -> notices.showFailure(Messages.tr("The review could not be read"), failure)));
    }

    private void apply(Path file, Review review) {
        Scene before = model.editor().scene();
        Optional<PixelCache> cache = model.workbench().cache();
        String reviewer = review.reviewer().isBlank() ? Quote.path(file.getFileName()) : review.reviewer();
        boolean refused = model.editor().editOrReport(scene -> EditOutcome.of(() -> ReviewedScene.of(scene, review).scene())
                .named(Messages.tr("Review of {0}", reviewer))).isPresent();
        if (refused) {
            return;
        }
        List<String> lines = new ArrayList<>();
        for (Review.Note note : review.notes()) {
            lines.add(Messages.tr("{0}, {1}: {2}", Math.round(note.x() * before.picture().width()),
                    Math.round(note.y() * before.picture().height()),
                    note.text()));
        }
        lines.addAll(ReviewedScene.of(before, review).notes());
        if (lines.isEmpty()) {
            message.show(Messages.tr("Review of {0} opened; undo restores the lights", reviewer));
        } else {
            notices.showNotes(Messages.tr("Review of {0}: notes with their pixels. Undo restores the lights.", reviewer), lines);
        }
        ForcedLiveUpdate.render(model.editor());
        Scene after = model.editor().scene();
        cache.ifPresent(picture -> new ReviewLooks(model).save(picture, before, after, reviewer));
    }
}
