package lightning.editor.window.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CancellationException;
import javafx.scene.control.MenuItem;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.base.work.Memory;
import lightning.base.work.Workers;
import lightning.editor.document.Command;
import lightning.editor.loop.Frame;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.StatusMessage;
import lightning.format.exr.ExrType;
import lightning.format.jen.JenFile;
import lightning.format.layer.LayerFile;
import lightning.format.picture.PictureFile;
import lightning.render.cache.PixelCache;
import lightning.render.image.ViewTransform;
import lightning.render.relight.MemoryNeed;
import lightning.render.relight.tile.Options;

/** Writes the traced picture for other programs, beside the window's thread: its layers, or all that its film holds. */
final class PictureExport {
    private final EditorModel model;
    private final StatusMessage message;
    private final FilePrompt prompt;
    private final Notices notices;

    PictureExport(EditorModel model, FilePrompt prompt, Notices notices) {
        this.model = model;
        message = model.editor().message();
        this.prompt = prompt;
        this.notices = notices;
    }

    /** One for each kind. */
    List<MenuItem> items() {
        return Arrays.stream(ExportKind.values())
                .map(kind -> CommandItems.of(model.commands()).lastingValue(Command.EXPORT, kind.title(), () -> ask(kind)))
                .toList();
    }

    private void ask(ExportKind kind) {
        String ending = kind.format().ending();
        prompt.pictureToWrite(model.editor().document().file().resolveSibling(JenFile.stem(model.editor().document().name()) + ending))
                .ifPresent(chosen -> notices.withEnding(model.files(), chosen, ending, file -> export(kind, file)));
    }

    private void export(ExportKind kind, Path file) {
        PixelCache known = model.workbench().known().orElse(null);
        Frame frame = model.picture().frame();
        if (model.fileWork().file() != null || known == null || frame == null) {
            message.show(Texts.of("Nothing is exported while a file is read or a picture is begun"));
            return;
        }
        ViewTransform view = model.picture().viewProperty().get().ofPicture();
        String name = Quote.path(file.getFileName());
        model.fileWork().write(file);
        model.files().beside(() -> {
            write(kind, file, known, frame, view);
            return file;
        }, _ -> end(file, Texts.of("Exported {0}", name)), why -> {
            end(file, why instanceof CancellationException ? Texts.of("Export of {0} cancelled", name) : "");
            if (!(why instanceof CancellationException)) {
                notices.failed(Texts.of("The picture could not be exported"), why);
            }
        });
    }

    private void write(ExportKind kind, Path file, PixelCache known, Frame frame, ViewTransform view) throws IOException {
        if (!kind.hasLayers()) {
            PictureFile.write(file, frame.film(), view, kind.bits());
            return;
        }
        var layers = new LayerFile(known, Options.DEFAULT.engines(), kind.bits() == Short.SIZE ? ExrType.HALF : ExrType.FLOAT);
        try (var workers = new Workers(Workers.available())) {
            layers.write(file, Memory.available() - MemoryNeed.of(known), workers,
                    new ReadingLine(file, model.fileWork(), model.files().window(), message));
        }
    }

    private void end(Path file, String text) {
        model.fileWork().end(file);
        message.show(text);
    }
}
