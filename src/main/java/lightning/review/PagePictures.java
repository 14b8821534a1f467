package lightning.review;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.PictureFilms;
import lightning.render.relight.Renderer;
import lightning.scene.Scene;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Renders the pictures of a page, one after the other, and writes their layers. */
record PagePictures(Renderer renderer, RenderOptions options, LayerBlocks blocks, boolean hasThumbnails) {
    /** Layers of one size. */
    private record Layers(ArrayNode ids) {
        static Layers in(ObjectNode node, int width, int height) {
            return new Layers(node.put("width", width).put("height", height).putArray("layers"));
        }
    }

    /**
     * Writes the layers of a picture: those of its lights, the rest, and the pictures of looks that faders cannot show.
     *
     * @param rendering counts tiles
     * @param dividing  counts lights
     * @return JSON that names the layers
     * @throws CancellationException if a progress requested cancellation
     */
    ObjectNode write(ReviewPicture picture, Progress rendering, Progress dividing) throws IOException {
        renderer.render(picture.scene(), rendering);
        PixelCache cache = renderer.cache();
        Film film = cache.film();
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        picture.frame().ifPresent(frame -> node.put("frame", frame));
        Layers full = Layers.in(node, film.width(), film.height());
        Optional<Layers> small = hasThumbnails
                ? Optional.of(
                        Layers.in(node.putObject("small"), Thumbnail.width(film.width()), Thumbnail.height(film.width(), film.height())))
                : Optional.empty();
        ArrayNode lights = node.putArray("lights");
        float[] rest = film.toScanlines();
        try {
            new PictureFilms(cache, options).forEachShining(dividing, (light, layer) -> {
                float[] part = layer.toScanlines();
                for (int i = 0; i < part.length; i++) {
                    rest[i] -= part[i];
                }
                lights.add(light.name(picture.scene()));
                add(layer, full, small);
            });
            add(Film.ofScanlines(film.width(), film.height(), rest), full, small);
            writeLooks(picture, node.putArray("looks"), full, small, dividing);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
        return node;
    }

    private void writeLooks(ReviewPicture picture, ArrayNode looks, Layers full, Optional<Layers> small, Progress progress) {
        for (ReviewLook look : picture.looks()) {
            Optional<ObjectNode> faders = LookFaders.of(picture.scene(), look.scene());
            if (faders.isPresent()) {
                looks.add(faders.get());
            } else {
                looks.addObject().put("layer", full.ids().size());
                add(film(look.scene(), progress), full, small);
            }
        }
    }

    private Film film(Scene scene, Progress progress) {
        renderer.render(scene, progress.cancellationOnly());
        return renderer.film();
    }

    private void add(Film film, Layers full, Optional<Layers> small) {
        try {
            full.ids().add(blocks.add(film));
            if (small.isPresent()) {
                small.get().ids().add(blocks.add(Thumbnail.of(film)));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
