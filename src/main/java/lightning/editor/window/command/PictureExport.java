package lightning.editor.window.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import javafx.scene.control.MenuItem;
import lightning.base.text.Messages;
import lightning.base.work.HeapBudget;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.editor.Command;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.StatusMessage;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.format.jen.JenFile;
import lightning.layer.ExrLayout;
import lightning.layer.LayeredExrWriter;
import lightning.layer.SceneMetadata;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.MemoryEstimate;

/** Exports the traced picture, its layers or its mattes in the background. */
final class PictureExport {
    private final EditorModel model;
    private final StatusMessage message;
    private final FilePrompt prompt;
    private final EditorDialogs notices;

    PictureExport(EditorModel model, FilePrompt prompt, EditorDialogs notices) {
        this.model = model;
        message = model.editor().message();
        this.prompt = prompt;
        this.notices = notices;
    }

    /** Returns a menu item for each format. */
    List<MenuItem> items() {
        return Arrays.stream(ExportFormat.values())
                .map(kind -> CommandMenuItems.forMenu(model.commands()).updatingValue(Command.EXPORT, kind.title(),
                        () -> promptAndExport(kind)))
                .toList();
    }

    private void promptAndExport(ExportFormat kind) {
        String ending = kind.format().extension();
        prompt.pictureToWrite(model.editor().document().proposedFile(JenFile.stem(model.editor().document().name()) + ending))
                .ifPresent(chosen -> notices.withExtension(model.files(), chosen, ending, file -> export(kind, file)));
    }

    private void export(ExportFormat kind, Path file) {
        FinalPicture picture = FinalPicture.of(model);
        if (model.fileActivity().file() != null || model.picture().frame() == null) {
            message.show(Messages.tr("Wait until the file is loaded and rendering has started"));
            return;
        }
        ViewTransform view = model.picture().outputView();
        new BackgroundExport(model, notices).start(file, Messages.tr("The image could not be exported"),
                (to, progress) -> picture.write(file, progress, (film, cache) -> write(kind, to, film, cache, view, progress)));
    }

    private void write(ExportFormat kind, Path file, Film film, PixelCache cache, ViewTransform view, Progress progress)
            throws IOException {
        if (kind.content().isEmpty()) {
            if (kind.format() == ImageFormat.EXR) {
                ImageFile.writeExr(file, film, kind.bits(), SceneMetadata.of(cache.scene(), Optional.empty()));
            } else {
                ImageFile.write(file, film, view, kind.bits());
            }
            return;
        }
        var layers =
                new LayeredExrWriter(cache, RenderOptions.DEFAULT.engines(), kind.content().get(), ExrLayout.DEFAULT, Optional.empty());
        try (var workers = new WorkerPool(WorkerPool.processorCount())) {
            layers.write(file, HeapBudget.availableBytes() - MemoryEstimate.usedBytes(cache), workers, progress);
        }
    }
}
