package lightning.editor.window.command;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import javafx.scene.control.MenuItem;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.EditOutcome;
import lightning.document.look.LookFiles;
import lightning.editor.Command;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.StatusMessage;
import lightning.format.jen.JenFile;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.ViewTransform;
import lightning.render.relight.Renderer;
import lightning.review.Review;
import lightning.review.ReviewContent;
import lightning.review.ReviewFilm;
import lightning.review.ReviewLooks;
import lightning.review.ReviewPage;
import lightning.review.ReviewPicture;
import lightning.review.ReviewReader;
import lightning.review.ReviewedScene;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;

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

    /** Returns the menu items that write a page of the picture, and one of the shot. */
    List<MenuItem> exportItems() {
        CommandMenuItems items = CommandMenuItems.forMenu(model.commands());
        return List.of(items.updatingValue(Command.EXPORT, Messages.tr("Review Page…"), () -> promptAndExport(this::export)),
                items.updatingValue(Command.EXPORT_SHOT, Messages.tr("Review Page of the Shot…"), () -> promptAndExport(this::exportShot)));
    }

    private void promptAndExport(Consumer<Path> write) {
        prompt.pageToWrite(model.editor().document().proposedFile(JenFile.stem(model.editor().document().name()) + PAGE))
                .ifPresent(chosen -> notices.withExtension(model.files(), chosen, PAGE, write));
    }

    private void exportShot(Path file) {
        AnimatedScene content = model.editor().document().content();
        if (content.shot().isEmpty()) {
            message.show(Messages.tr("The scene has no shot"));
            return;
        }
        Shot shot = content.shot().get();
        ViewTransform view = model.picture().outputView();
        String title = model.editor().document().name();
        LookFiles folder = model.editor().looksFolder();
        model.files().runConcurrently(() -> {
            Scene base = ReviewFilm.reduced(content.base());
            List<ReviewPicture> pictures = ReviewLooks.film(folder.list(base.stage()), shot, base, ReviewFilm.frames(shot));
            return new ReviewContent(title, base, pictures, view, Optional.empty());
        }, film -> write(file, film, Optional.empty()),
                failure -> notices.showFailure(Messages.tr("The page could not be written"), failure));
    }

    private void export(Path file) {
        PixelCache cache = model.workbench().cache().orElse(null);
        if (model.fileActivity().file() != null || cache == null) {
            message.show(Messages.tr("Wait until the file is loaded and rendering has started"));
            return;
        }
        ViewTransform view = model.picture().outputView();
        String title = model.editor().document().name();
        LookFiles folder = model.editor().looksFolder();
        model.files().runConcurrently(() -> {
            ReviewLooks looks = ReviewLooks.of(folder.list(cache.scene().stage()), cache.scene());
            return ReviewContent.of(title, new ReviewPicture(OptionalInt.empty(), cache.scene(), looks.looks()), view);
        }, content -> write(file, content, Optional.of(cache)),
                failure -> notices.showFailure(Messages.tr("The page could not be written"), failure));
    }

    /** @param cache cache of the only picture; empty to render */
    private void write(Path file, ReviewContent content, Optional<PixelCache> cache) {
        message.show(Messages.tr("Writing {0}, about {1} MB", Quote.path(file.getFileName()),
                Math.max(1, Math.round(content.estimatedBytes() / 1e6))));
        new BackgroundExport(model, notices).start(file, Messages.tr("The page could not be written"), (to, progress) -> {
            try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
                cache.ifPresent(renderer::restore);
                ReviewPage.write(to, content, renderer, RenderOptions.DEFAULT, progress);
            }
        });
    }

    private void promptAndOpen() {
        prompt.reviewToOpen(model.fileImporter().folder()).ifPresent(file -> model.files().runConcurrently(() -> ReviewReader.read(file),
                review -> apply(file, review), failure -> notices.showFailure(Messages.tr("The review could not be read"), failure)));
    }

    private void apply(Path file, Review review) {
        Scene before = model.editor().scene();
        Optional<PixelCache> cache = model.workbench().cache();
        String reviewer = review.reviewer().isBlank() ? Quote.path(file.getFileName()) : review.reviewer();
        boolean refused = model.editor().editAndRenderOrReport(scene -> EditOutcome.of(() -> ReviewedScene.of(scene, review).scene())
                .named(Messages.tr("Review of {0}", reviewer)), null).isPresent();
        if (refused) {
            return;
        }
        List<String> lines = new ArrayList<>();
        for (Review.Note note : review.notes()) {
            long x = Math.round(note.x() * before.picture().width());
            long y = Math.round(note.y() * before.picture().height());
            lines.add(note.frame().isPresent() ? Messages.tr("Frame {0}, {1}, {2}: {3}", note.frame().getAsInt(), x, y, note.text())
                    : Messages.tr("{0}, {1}: {2}", x, y, note.text()));
        }
        lines.addAll(ReviewedScene.of(before, review).notes());
        if (lines.isEmpty()) {
            message.show(Messages.tr("Review of {0} opened; undo restores the lights", reviewer));
        } else {
            notices.showNotes(Messages.tr("Review of {0}: notes with their pixels. Undo restores the lights.", reviewer), lines);
        }
        Scene after = model.editor().scene();
        cache.ifPresent(picture -> new ReviewedLooks(model).save(picture, before, after, reviewer));
    }
}
