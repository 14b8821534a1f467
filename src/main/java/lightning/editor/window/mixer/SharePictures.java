package lightning.editor.window.mixer;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.editor.document.Channel;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.SmallShares;
import lightning.scene.Scene;

/**
 * A small picture of what each channel gives to the traced picture, and how much of its light that is.
 *
 * @param scene    what the traced picture shows
 * @param channels all of its channels
 * @param whole    the traced picture itself
 */
record SharePictures(Scene scene, Map<Channel, One> channels, One whole) {

    /**
     * Of one channel.
     *
     * @param width  pixels; likewise {@code height}
     * @param pixels {@code int[width * height]}, opaque 0xFFRRGGBB
     * @param part   its part of the picture's mean luminance, 0…1; 0 of a black picture
     */
    record One(int width, int height, int[] pixels, double part) {
        // An array in a record: written once by its maker, never after.
    }

    /** Makes the pictures as the display shows light; takes a while. */
    static SharePictures of(SmallShares shares, ViewTransform view) {
        double all = SmallShares.brightness(shares.picture());
        Map<Channel, One> channels = new HashMap<>();
        for (Channel channel : Channel.all(shares.scene())) {
            channels.put(channel, one(shares, view, rgb(shares, channel), all));
        }
        return new SharePictures(shares.scene(), channels, one(shares, view, shares.picture(), all));
    }

    private static float[] rgb(SmallShares shares, Channel channel) {
        return switch (channel) {
            case Channel.OfLight _ -> shares.lights(channel.places(shares.scene()));
            case Channel.OfBank _ -> shares.lights(channel.places(shares.scene()));
            case Channel.OfEnvironment _ -> shares.environment();
        };
    }

    private static One one(SmallShares shares, ViewTransform view, float[] rgb, double all) {
        int[] pixels = view.toPixels(Film.ofScanlines(shares.width(), shares.height(), rgb));
        return new One(shares.width(), shares.height(), pixels, all > 0 ? SmallShares.brightness(rgb) / all : 0);
    }

    /**
     * Of a channel of the scene as it is now: a light or bank that was renamed since is the one at its place.
     *
     * @param now the edited scene, which has the channel
     */
    Optional<One> of(Channel channel, Scene now) {
        One known = channels.get(channel);
        return known != null ? Optional.of(known) : before(channel, now).map(channels::get);
    }

    private Optional<Channel> before(Channel channel, Scene now) {
        List<Channel> then = Channel.all(scene);
        List<Channel> all = Channel.all(now);
        int place = all.indexOf(channel);
        return place < 0 || then.size() != all.size() || all.contains(then.get(place)) ? Optional.empty() : Optional.of(then.get(place));
    }
}
