package lightning.editor.loop;

import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.image.Film;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.relight.Renderer;
import lightning.render.relight.plan.ReflectionMode;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;

/**
 * Makes what a {@link DisplayMode} shows of a renderer's picture. A light's share is composed from what the renderer keeps; where
 * effects are hidden, a second renderer keeps the picture without them.
 */
final class DisplayRenderer implements AutoCloseable {
    private Renderer effectRenderer;

    /**
     * @throws PictureTooLargeException       if the picture without effects does not fit into memory beside the picture
     * @throws CancellationException if {@code progress} asked to stop
     */
    Film film(Renderer renderer, DisplayMode mode, Progress progress) {
        Renderer source = mode.effects().equals(ViewEffects.ALL) ? renderer : renderWithEffects(renderer, mode.effects(), progress);
        return mode.light().isPresent() ? source.lightImage(mode.light().get(), progress) : source.film();
    }

    /** The picture without some effects; its mirrors show what the picture's show. */
    private Renderer renderWithEffects(Renderer renderer, ViewEffects effects, Progress progress) {
        var options = renderer.options().withReflections(ReflectionMode.STALE).withView(effects)
                .withMemory(renderer.options().memory() - renderer.bytes());
        if (effectRenderer == null) {
            effectRenderer = new Renderer(options);
        }
        effectRenderer.setOptions(options);
        Scene mirrored = renderer.cache().mirroredScene();
        update(mirrored, renderer.isFinished(), progress);
        if (!effectRenderer.hasCurrentReflections()) {
            effectRenderer.updateReflections(progress);
        }
        update(renderer.scene(), renderer.isFinished(), progress);
        return effectRenderer;
    }

    /** @param isFinished whether the samples are wanted too */
    private void update(Scene scene, boolean isFinished, Progress progress) {
        if (isFinished) {
            effectRenderer.render(scene, progress);
        } else {
            effectRenderer.renderCenters(effectRenderer.plan(scene), progress);
        }
    }

    /** The bytes that hiding takes beside the picture. */
    long bytes() {
        return effectRenderer == null ? 0 : effectRenderer.bytes();
    }

    /** The picture as it is; what hiding took is given back. */
    Film fullPicture(Renderer renderer) {
        close();
        return renderer.film();
    }

    @Override
    public void close() {
        if (effectRenderer != null) {
            effectRenderer.close();
            effectRenderer = null;
        }
    }
}
