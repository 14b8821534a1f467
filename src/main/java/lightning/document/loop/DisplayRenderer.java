package lightning.document.loop;

import static java.util.Objects.requireNonNull;

import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.image.Film;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.relight.Renderer;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/**
 * Renders the view of a {@link DisplayMode}. Composes one light's contribution from the renderer's cache. Uses a second renderer with its
 * own cache for hidden effects.
 */
final class DisplayRenderer implements AutoCloseable {
    private @Nullable Renderer effectRenderer;

    /**
     * @throws PictureTooLargeException if the image without effects does not fit into memory together with the full image
     * @throws CancellationException    if {@code progress} requests a stop
     */
    Film film(Renderer renderer, DisplayMode mode, Progress progress) {
        Renderer source = mode.effects().equals(ViewEffects.ALL) ? renderer : renderWithEffects(renderer, mode.effects(), progress);
        return mode.light().isPresent() ? source.contribution(new SceneElement.OfLight(mode.light().get()), progress) : source.film();
    }

    /** Renders the image without some effects. Its reflections show the scene that the full image's reflections show. */
    private Renderer renderWithEffects(Renderer renderer, ViewEffects effects, Progress progress) {
        var options = renderer.options().withReflectionsOnRequest().withView(effects)
                .withMemory(renderer.options().memory() - renderer.state().bytes());
        if (effectRenderer == null) {
            effectRenderer = new Renderer(options);
        }
        effectRenderer.setOptions(options);
        Scene mirrored = renderer.cache().mirrored().scene();
        update(mirrored, renderer.state().isFinished(), progress);
        if (!effectRenderer.cache().hasCurrentReflections()) {
            effectRenderer.updateReflections(progress);
        }
        update(renderer.scene(), renderer.state().isFinished(), progress);
        return effectRenderer;
    }

    /** @param isFinished whether to render the anti-aliasing samples too */
    private void update(Scene scene, boolean isFinished, Progress progress) {
        if (isFinished) {
            requireNonNull(effectRenderer).render(scene, progress);
        } else {
            Renderer renderer = requireNonNull(effectRenderer);
            renderer.renderCenters(renderer.plan(scene), progress);
        }
    }

    /** Returns the additional bytes of the second renderer. */
    long bytes() {
        return effectRenderer == null ? 0 : effectRenderer.state().bytes();
    }

    /** Returns the full image and frees the second renderer. */
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
