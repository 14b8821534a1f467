package lightning.edit.loop;

import java.util.concurrent.CancellationException;
import lightning.effects.ViewEffects;
import lightning.image.Film;
import lightning.relight.MemoryNeed;
import lightning.relight.PictureTooLarge;
import lightning.relight.Renderer;
import lightning.relight.plan.Reflections;
import lightning.scene.Scene;
import lightning.work.Progress;

/**
 * Makes what a {@link Look} shows of a renderer's picture. A light's share is composed from what the renderer keeps; where
 * effects are hidden, a second renderer keeps the picture without them.
 */
final class Looking implements AutoCloseable {
    private Renderer hiding;

    /**
     * @throws PictureTooLarge       if the picture without effects does not fit into memory beside the picture
     * @throws CancellationException if {@code progress} asked to stop
     */
    Film film(Renderer picture, Look look, Progress progress) {
        Renderer shown = look.effects().equals(ViewEffects.ALL) ? picture : hiding(picture, look.effects(), progress);
        return look.light().isPresent() ? shown.share(look.light().get(), progress) : shown.film();
    }

    /** The picture without some effects; its mirrors show what the picture's show. */
    private Renderer hiding(Renderer picture, ViewEffects effects, Progress progress) {
        var options = picture.options().withReflections(Reflections.STALE).withView(effects)
                .withMemory(picture.options().memory() - MemoryNeed.of(picture.cache()));
        if (hiding == null) {
            hiding = new Renderer(options);
        }
        hiding.change(options);
        Scene mirrored = picture.cache().mirroredScene();
        hiding.render(mirrored, progress);
        hiding.updateReflections(progress);
        hiding.render(picture.scene(), progress);
        return hiding;
    }

    /** The bytes that hiding takes beside the picture. */
    long bytes() {
        return hiding == null || !hiding.hasPicture() ? 0 : MemoryNeed.of(hiding.cache());
    }

    /** The picture as it is; what hiding took is given back. */
    Film plain(Renderer picture) {
        close();
        return picture.film();
    }

    @Override
    public void close() {
        if (hiding != null) {
            hiding.close();
            hiding = null;
        }
    }
}
