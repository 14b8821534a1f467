package lightning.editor.window.mixer;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.document.MixerChannel;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.LightShares;
import lightning.render.relight.LightThumbnails;
import lightning.scene.Scene;

/**
 * Thumbnails of each channel's contribution to the traced picture, and the channels' shares of its light.
 *
 * @param scene scene of the traced picture
 * @param images thumbnail of each channel
 * @param master thumbnail of the traced picture itself
 */
record ChannelImages(Scene scene, Map<MixerChannel, ChannelImage> images, ChannelImage master) {

    /**
     * Thumbnail of one channel.
     *
     * @param width pixels
     * @param height pixels
     * @param pixels {@code int[width * height]}, opaque 0xFFRRGGBB
     * @param fraction share of the picture's light, of the thumbnail's pixels until {@link LightShares} are known; 0 for a black picture
     */
    record ChannelImage(int width, int height, int[] pixels, double fraction) {
        // Immutable by convention: the array is written only before construction.
    }

    /** Creates the thumbnails through the view transform. Takes too long for the window's thread. */
    static ChannelImages of(LightThumbnails shares, ViewTransform view) {
        double totalBrightness = LightThumbnails.brightness(shares.image());
        Map<MixerChannel, ChannelImage> images = new HashMap<>();
        for (MixerChannel channel : MixerChannel.channelsOf(shares.scene())) {
            images.put(channel, image(shares, view, shares.sum(channel.contributions(shares.scene())), totalBrightness));
        }
        return new ChannelImages(shares.scene(), images, image(shares, view, shares.image(), totalBrightness));
    }

    /** Returns these thumbnails with the shares of whole pictures; channels that their scene lacks keep theirs. */
    ChannelImages withShares(LightShares shares) {
        Scene of = shares.scene();
        Map<MixerChannel, ChannelImage> updated = new HashMap<>();
        images.forEach((channel, image) -> updated.put(channel, !channel.isIn(of) ? image
                : new ChannelImage(image.width(), image.height(), image.pixels(),
                        share(shares, channel))));
        return new ChannelImages(scene, updated, master);
    }

    private static double share(LightShares shares, MixerChannel channel) {
        return channel.contributions(shares.scene()).stream().mapToDouble(shares::of).sum();
    }

    private static ChannelImage image(LightThumbnails shares, ViewTransform view, float[] rgb, double totalBrightness) {
        int[] pixels = view.toPixels(Film.ofScanlines(shares.width(), shares.height(), rgb));
        return new ChannelImage(shares.width(), shares.height(), pixels,
                totalBrightness > 0 ? LightThumbnails.brightness(rgb) / totalBrightness : 0);
    }

    /**
     * Returns the thumbnail of a channel of the current scene. A light or light group that was renamed since is matched by its index.
     *
     * @param newScene edited scene, which contains the channel
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
