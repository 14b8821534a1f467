package lightning.format.exchange.json;

import java.util.Optional;
import java.util.function.Consumer;
import lightning.base.text.RefusalException;
import lightning.scene.AntialiasMode;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.ViewCurve;
import lightning.scene.ViewSettings;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * JSON form of a picture's settings, with the names and words of {@code .jen} files: {@code size} in pixels, {@code depth}, {@code reflection_rays}, {@code antialias},
 * {@code samples}, {@code view}, {@code exposure}, and {@code indirect}, which is absent without indirect light.
 */
public final class PictureJson {
    private PictureJson() {}

    public static void write(ObjectNode out, PictureSettings picture) {
        out.putArray("size").add(picture.width()).add(picture.height());
        out.put("depth", picture.depth());
        out.put("reflection_rays", picture.reflectionRays());
        out.put("antialias", picture.sampling().antialias().word());
        out.put("samples", picture.sampling().grid());
        out.put("view", picture.view().curve().word());
        out.put("exposure", picture.view().exposure());
        picture.indirect().ifPresent(indirect -> AttributeJson.write(out.putObject("indirect"), indirect, IndirectSettings.ATTRIBUTES));
    }

    /**
     * Returns the settings with those that are present. A view or an exposure without the other has the other's default.
     *
     * @param onError receives a message for an invalid value; settings in the order above keep their values from it on
     */
    public static PictureSettings read(JsonNode in, PictureSettings picture, Consumer<String> onError) {
        PictureSettings result = picture;
        try {
            JsonNode size = in.path("size");
            if (size.size() == 2) {
                result = result.withSize(size.get(0).asInt(0), size.get(1).asInt(0));
            }
            result = result.withView(in.isMissingNode() ? result.view() : view(in)).withDepth(in.path("depth").asInt(result.depth()))
                    .withReflectionRays(in.path("reflection_rays").asInt(result.reflectionRays()));
            if (in.has("antialias") || in.has("samples")) {
                result = result.withSampling(new SamplingSettings(AntialiasMode.of(in.path("antialias").asString("off")),
                        in.path("samples").asInt(SamplingSettings.DEFAULT.grid())));
            }
            if (in.path("indirect").isObject()) {
                result = result.withIndirect(Optional.of(
                        AttributeJson.read(in.get("indirect"), IndirectSettings.DEFAULT, IndirectSettings.ATTRIBUTES, (_, _) -> false,
                                onError)));
            }
        } catch (RefusalException e) {
            onError.accept(e.getMessage());
        }
        return result;
    }

    private static ViewSettings view(JsonNode in) {
        ViewSettings view = new ViewSettings(ViewCurve.SRGB, in.path("exposure").asDouble(0));
        return in.has("view") ? view.withCurve(ViewCurve.of(in.get("view").asString(""))) : view;
    }
}
