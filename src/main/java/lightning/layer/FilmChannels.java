package lightning.layer;

import java.util.List;
import java.util.stream.Stream;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrPrimaries;
import lightning.format.exr.ExrType;
import lightning.render.engine.Engine;
import lightning.render.image.Film;

/**
 * The image: red, green and blue.
 *
 * @param type HALF or FLOAT
 */
record FilmChannels(Film film, ExrType type, ExrPrimaries primaries) implements ChannelSource {
    @Override
    public List<ExrChannel> channels() {
        return Stream.of("R", "G", "B").map(name -> new ExrChannel(name, type)).toList();
    }

    @Override
    public TileWriter writer(Engine engine) {
        return (tile, _, sink) -> sink.putColors(0,
                primaries.convert(new float[][] {film.red(tile), film.green(tile), film.blue(tile)}));
    }
}
