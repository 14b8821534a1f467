package lightning.shot;

import java.util.Optional;
import lightning.render.image.Film;

/** Host without films and caches: only records which frames it updates. */
public abstract class FilmlessHost implements FrameHost {
    @Override
    public Optional<Film> film(int frame) {
        return Optional.empty();
    }

    @Override
    public void focus(int frame) {}

    @Override
    public void drop(int frame) {}

    @Override
    public CacheUsage usage() {
        return CacheUsage.NONE;
    }

    @Override
    public void close() {}
}
