package lightning.editor.window.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.text.Messages;
import lightning.base.work.HeapBudget;
import lightning.base.work.Progress;
import lightning.document.loop.Frame;
import lightning.editor.window.model.EditorModel;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.scene.Scene;

/**
 * Image of a scene at the scene's own size, for a file: the traced one, or one that is rendered beside the work.
 *
 * @param scene  scene of the document
 * @param traced image that the editor shows; empty before the first, or if it has another size
 * @param cache  cache of that image
 */
record FinalPicture(EditorModel model, Scene scene, Optional<Frame> traced, Optional<PixelCache> cache) {
    /** Writes an image; runs on its own thread. */
    @FunctionalInterface
    interface Writer {
        void write(Film film, PixelCache cache) throws IOException;
    }

    /** Returns the image of the open scene. */
    static FinalPicture of(EditorModel model) {
        Scene scene = model.editor().scene();
        Optional<Frame> frame = Optional.ofNullable(model.picture().frame()).filter(f -> hasSize(f.scene(), scene));
        return new FinalPicture(model, scene, frame, model.workbench().cache().filter(c -> frame.isPresent() && hasSize(c.scene(), scene)));
    }

    private static boolean hasSize(Scene a, Scene b) {
        return a.picture().width() == b.picture().width() && a.picture().height() == b.picture().height();
    }

    /** Returns whether the editor shows an image of this size. */
    boolean isTraced() {
        return cache.isPresent();
    }

    /**
     * Writes the image; renders it first if the editor shows one of another size.
     *
     * @param file named in the status line
     * @throws IOException if the writer throws it
     * @throws CancellationException if the progress canceled
     */
    void write(Path file, Progress progress, Writer writer) throws IOException {
        if (isTraced()) {
            writer.write(traced.orElseThrow().film(), cache.get());
            return;
        }
        model.files().windowExecutor().execute(() -> model.fileActivity().setTitle(file, Messages.tr("Rendering")));
        try (var renderer = new Renderer(RenderOptions.DEFAULT.withMemory(HeapBudget.availableBytes()))) {
            renderer.renderOrClear(scene, progress);
            if (progress.isCanceled()) {
                throw new CancellationException();
            }
            writer.write(renderer.cache().film(), renderer.cache());
        }
    }
}
