package lightning.editor.loop;

import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.image.Film;
import lightning.render.relight.PictureTooLarge;
import lightning.render.relight.Renderer;
import lightning.render.relight.plan.Reflections;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;

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
                .withMemory(picture.options().memory() - picture.bytes());
        if (hiding == null) {
            hiding = new Renderer(options);
        }
        hiding.change(options);
        Scene mirrored = picture.cache().mirroredScene();
        bring(mirrored, picture.isFinished(), progress);
        if (!hiding.reflectionsAreCurrent()) {
            hiding.updateReflections(progress);
        }
        bring(picture.scene(), picture.isFinished(), progress);
        return hiding;
    }

    /** @param finished whether the samples are wanted too */
    private void bring(Scene scene, boolean finished, Progress progress) {
        if (finished) {
            hiding.render(scene, progress);
        } else {
            hiding.renderCenters(hiding.plan(scene), progress);
        }
    }

    /** The bytes that hiding takes beside the picture. */
    long bytes() {
        return hiding == null ? 0 : hiding.bytes();
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
