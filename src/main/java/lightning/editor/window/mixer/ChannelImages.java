package lightning.editor.window.mixer;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.editor.document.MixerChannel;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.LightThumbnails;
import lightning.scene.Scene;

/**
 * A small picture of what each channel gives to the traced picture, and how much of its light that is.
 *
 * @param scene    what the traced picture shows
 * @param images all of its channels
 * @param master    the traced picture itself
 */
record ChannelImages(Scene scene, Map<MixerChannel, ChannelImage> images, ChannelImage master) {

    /**
     * Of one channel.
     *
     * @param width  pixels; likewise {@code height}
     * @param pixels {@code int[width * height]}, opaque 0xFFRRGGBB
     * @param fraction   its part of the picture's mean luminance, 0…1; 0 of a black picture
     */
    record ChannelImage(int width, int height, int[] pixels, double fraction) {
        // An array in a record: written once by its maker, never after.
    }

    /** Makes the pictures as the display shows light; takes a while. */
    static ChannelImages of(LightThumbnails shares, ViewTransform view) {
        double totalBrightness = LightThumbnails.brightness(shares.image());
        Map<MixerChannel, ChannelImage> images = new HashMap<>();
        for (MixerChannel channel : MixerChannel.channelsOf(shares.scene())) {
            images.put(channel, image(shares, view, rgb(shares, channel), totalBrightness));
        }
        return new ChannelImages(shares.scene(), images, image(shares, view, shares.image(), totalBrightness));
    }

    private static float[] rgb(LightThumbnails shares, MixerChannel channel) {
        return switch (channel) {
            case MixerChannel.OfLight _ -> shares.sumOfLights(channel.lightIndices(shares.scene()));
            case MixerChannel.OfLightGroup _ -> shares.sumOfLights(channel.lightIndices(shares.scene()));
            case MixerChannel.OfEnvironment _ -> shares.environmentImage();
        };
    }

    private static ChannelImage image(LightThumbnails shares, ViewTransform view, float[] rgb, double totalBrightness) {
        int[] pixels = view.toPixels(Film.ofScanlines(shares.width(), shares.height(), rgb));
        return new ChannelImage(shares.width(), shares.height(), pixels,
                totalBrightness > 0 ? LightThumbnails.brightness(rgb) / totalBrightness : 0);
    }

    /**
     * Of a channel of the scene as it is now: a light or bank that was renamed since is the one at its place.
     *
     * @param newScene the edited scene, which has the channel
     */
    Optional<ChannelImage> of(MixerChannel channel, Scene newScene) {
        ChannelImage image = images.get(channel);
        return image != null ? Optional.of(image) : previousChannel(channel, newScene).map(images::get);
    }

    private Optional<MixerChannel> previousChannel(MixerChannel channel, Scene newScene) {
        List<MixerChannel> oldChannels = MixerChannel.channelsOf(scene);
        List<MixerChannel> newChannels = MixerChannel.channelsOf(newScene);
        int index = newChannels.indexOf(channel);
        return index < 0 || oldChannels.size() != newChannels.size() || newChannels.contains(oldChannels.get(index)) ? Optional.empty()
                : Optional.of(oldChannels.get(index));
    }
}
