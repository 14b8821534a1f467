package lightning.editor.window.widget;

import java.util.Locale;
import javafx.util.StringConverter;
import lightning.base.text.Texts;
import lightning.scene.LightType;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignL;
import org.kordamp.ikonli.materialdesign2.MaterialDesignS;
import org.kordamp.ikonli.materialdesign2.MaterialDesignW;

/** How the types of lights look and are called. */
public final class LightTypes {
    public static final StringConverter<LightType> CONVERTER = new StringConverter<>() {
        @Override
        public String toString(LightType type) {
            return type == null ? "" : title(type);
        }

        @Override
        public LightType fromString(String text) {
            return LightType.valueOf(text.toUpperCase(Locale.ROOT));
        }
    };

    private LightTypes() {}

    public static String title(LightType type) {
        return switch (type) {
            case POINT -> Texts.of("Point");
            case SPOT -> Texts.of("Spot");
            case DIRECTIONAL -> Texts.of("Directional");
            case RECT -> Texts.of("Rectangle");
            case DISC -> Texts.of("Disc");
        };
    }

    /** Within a sentence: {@code spot light}. */
    public static String light(LightType type) {
        return switch (type) {
            case POINT -> Texts.of("point light");
            case SPOT -> Texts.of("spot light");
            case DIRECTIONAL -> Texts.of("directional light");
            case RECT -> Texts.of("rectangle light");
            case DISC -> Texts.of("disc light");
        };
    }

    public static Ikon icon(LightType type) {
        return switch (type) {
            case POINT -> MaterialDesignL.LIGHTBULB_ON_OUTLINE;
            case SPOT -> MaterialDesignS.SPOTLIGHT_BEAM;
            case DIRECTIONAL -> MaterialDesignW.WHITE_BALANCE_SUNNY;
            case RECT -> MaterialDesignC.CARD_OUTLINE;
            case DISC -> MaterialDesignC.CIRCLE_OUTLINE;
        };
    }

    /** Whether a light shines. */
    public static Ikon bulb(boolean on) {
        return on ? MaterialDesignL.LIGHTBULB_ON : MaterialDesignL.LIGHTBULB_OFF_OUTLINE;
    }
}
