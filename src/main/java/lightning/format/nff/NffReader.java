package lightning.format.nff;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import lightning.format.mesh.PolygonTriangulator;
import lightning.format.mesh.TextTokenizer;
import lightning.format.mesh.UniqueNames;
import lightning.scene.node.Mesh;

/** Reader for NFF files: {@code v b l f c s p pp} and comments. Skips and notes entities of other dialects, line by line. */
public final class NffReader {
    /** Maximum number of spheres, cones and cylinders: that of a scene. */
    private static final int MAX_SOLIDS = 1_000_000;
    private static final int MAX_FILLS = 30_000;
    private static final int MAX_LIGHTS = 1000;

    private final ByteSource source;
    private final TextTokenizer text;
    private final ConversionNotes notes;
    private final NffViewBuilder view = new NffViewBuilder();
    private final List<NffFile.Light> lights = new ArrayList<>();
    private final Map<NffFile.Fill, Integer> fills = new LinkedHashMap<>();
    private final List<NffSolid> solids = new ArrayList<>();
    /** Meshes by fill: polygons at twice its index, patches at the next index. */
    private final Map<Integer, MeshBuilder> surfaces = new LinkedHashMap<>();
    private final PolygonTriangulator polygon = new PolygonTriangulator();
    private Rgb background = Rgb.BLACK;
    private int fill = -1;
    /** Expected content, for messages. */
    private String expected = "";
    private long vertices;
    private long triangles;

    private NffReader(ByteSource source, ConversionNotes notes) {
        this.source = source;
        this.notes = notes;
        text = new TextTokenizer(source);
    }

    /**
     * Reads a whole file.
     *
     * @param notes receives omitted features
     * @throws MeshException if it is invalid, or contains no shape
     * @throws IOException if it cannot be read
     */
    public static NffFile read(ByteSource source, ConversionNotes notes) throws IOException, MeshException {
        return new NffReader(source, notes).read();
    }

    private NffFile read() throws IOException, MeshException {
        do {
            while (text.readToken() && text.byteAt(0) != '#') {
                readEntity();
            }
        } while (text.nextLine());
        if (solids.isEmpty() && triangles == 0) {
            throw source.problem("", "must have shapes (c, s, p or pp)");
        }
        return new NffFile(view.build(), background, List.copyOf(lights), List.copyOf(fills.keySet()), List.copyOf(solids), surfaces());
    }

    private void readEntity() throws IOException, MeshException {
        String keyword = text.length() <= 16 ? text.text() : Quote.of(text.text());
        expected = "a number of " + keyword;
        switch (keyword) {
            // Every parameter of the view has a keyword of its own.
            case "v" -> {}
            case "from" -> view.from = readPoint();
            case "at" -> view.at = readPoint();
            case "up" -> view.up = readPoint();
            case "angle" -> view.angle = readNumber();
            case "hither", "yon" -> readNumber();
            case "resolution" -> {
                view.width = readInteger();
                view.height = readInteger();
            }
            case "b" -> background = readColor();
            case "l" -> readLight();
            case "f" -> readFill();
            case "s" -> readSphere();
            case "c" -> readCone();
            case "p" -> readPolygon(false);
            case "pp" -> readPolygon(true);
            default -> {
                notes.add("entities " + keyword);
                text.restOfLine();
            }
        }
    }

    private void readLight() throws IOException, MeshException {
        if (lights.size() == MAX_LIGHTS) {
            throw text.problem("a file must have at most " + MAX_LIGHTS + " lights");
        }
        Vec3 position = readPoint();
        Optional<Rgb> color = Optional.empty();
        if (hasNumber()) {
            color = Optional.of(readColor(text.number(expected)));
            text.readToken();
        }
        lights.add(new NffFile.Light(position, color));
        skipLine("extra words after lights (another dialect)");
    }

    /** Reads a fill. The color is required; missing parameters get those of a matte surface. */
    private void readFill() throws IOException, MeshException {
        Rgb color = readColor();
        double[] rest = {1, 0, 1, 0, 1};
        int count = 0;
        while (count < rest.length && hasNumber()) {
            rest[count++] = text.number(expected);
        }
        if (count == rest.length) {
            text.readToken();
        } else {
            notes.add("fills with fewer than eight numbers");
        }
        skipLine("extra words after fills (another dialect)");
        fill = fills.computeIfAbsent(new NffFile.Fill(color, rest[0], rest[1], rest[2], rest[3], rest[4]), _ -> fills.size());
        if (fills.size() > MAX_FILLS) {
            throw text.problem("a file must have at most " + MAX_FILLS + " different fills");
        }
    }

    private void readSphere() throws IOException, MeshException {
        Vec3 center = readPoint();
        addSolid(new NffSolid.Sphere(fill, center, Math.abs(noteInsideOut(readNumber()))));
    }

    private void readCone() throws IOException, MeshException {
        Vec3 base = readPoint();
        double baseRadius = readNumber();
        Vec3 apex = readPoint();
        double apexRadius = readNumber();
        noteInsideOut(Math.min(baseRadius, apexRadius));
        addSolid(new NffSolid.Cone(fill, base, Math.abs(baseRadius), apex, Math.abs(apexRadius)));
    }

    /** Notes a negative radius, whose inside only is visible; here both sides are. */
    private double noteInsideOut(double radius) {
        notes.add("inside-out shapes, imported as two-sided", radius < 0 ? 1 : 0);
        return radius;
    }

    private void addSolid(NffSolid solid) throws MeshException {
        if (solids.size() == MAX_SOLIDS) {
            throw text.problem("a file must have at most " + MAX_SOLIDS + " spheres, cones and cylinders");
        }
        solids.add(solid);
    }

    private void readPolygon(boolean smooth) throws IOException, MeshException {
        int count = readInteger();
        MeshBuilder builder = surfaces.computeIfAbsent(2 * fill + (smooth ? 1 : 0), _ -> new MeshBuilder(fill, smooth));
        int oldCount = builder.vertexCount();
        builder.beginPolygon();
        for (int i = 0; i < count; i++) {
            Vec3 p = readPoint();
            Vec3 n = smooth ? readDirection() : Vec3.ZERO;
            builder.addCorner((float) p.x(), (float) p.y(), (float) p.z(), (float) n.x(), (float) n.y(), (float) n.z());
        }
        vertices += builder.vertexCount() - oldCount;
        if (count < 3) {
            notes.add("polygons with fewer than three corners");
            return;
        }
        notes.add(
                "polygons with more than " + PolygonTriangulator.MAX_CORNERS + " corners, triangulated as convex",
                count > PolygonTriangulator.MAX_CORNERS ? 1 : 0);
        triangles += count - 2;
        if (vertices > MeshLimits.VERTICES || triangles > MeshLimits.TRIANGLES) {
            throw text.problem("a file must have at most " + MeshLimits.TRIANGLES + " triangles and " + MeshLimits.VERTICES + " vertices");
        }
        builder.endPolygon(polygon);
    }

    private List<NffFile.Surface> surfaces() throws MeshException {
        var names = new UniqueNames();
        List<NffFile.Surface> meshes = new ArrayList<>();
        for (MeshBuilder builder : surfaces.values()) {
            if (builder.triangleCount() > 0) {
                meshes.add(new NffFile.Surface(builder.fill, names.unique(builder.isSmooth() ? "patches" : "polygons", "mesh"),
                        builder.mesh()));
            }
        }
        return List.copyOf(meshes);
    }

    /** Skips the rest of a line from the last token on, and notes it unless it is a comment. */
    private void skipLine(String kind) throws IOException, MeshException {
        notes.add(kind, text.length() > 0 && text.byteAt(0) != '#' ? 1 : 0);
        text.restOfLine();
    }

    /** Reads the next token, on this line or a following one. */
    private void nextToken() throws IOException, MeshException {
        while (!text.readToken() || text.byteAt(0) == '#') {
            if (!text.nextLine()) {
                throw text.problem("expected " + expected + ", found the end of the file");
            }
        }
    }

    /** Reads the next token of this line; returns true if it looks like a number. */
    private boolean hasNumber() throws IOException, MeshException {
        return text.readToken() && (text.byteAt(0) >= '0' && text.byteAt(0) <= '9' || text.byteAt(0) == '-' || text.byteAt(0) == '+'
                || text.byteAt(0) == '.');
    }

    private double readNumber() throws IOException, MeshException {
        nextToken();
        return text.number(expected);
    }

    private int readInteger() throws IOException, MeshException {
        nextToken();
        return (int) text.integer(expected, 0, Integer.MAX_VALUE);
    }

    private Vec3 readDirection() throws IOException, MeshException {
        return new Vec3(readNumber(), readNumber(), readNumber());
    }

    private Vec3 readPoint() throws IOException, MeshException {
        Vec3 p = readDirection();
        if (p.maxAbs() > Mesh.MAX_COORDINATE) {
            throw text.problem("a coordinate must be at most " + DecimalNumber.format(Mesh.MAX_COORDINATE) + " in absolute value, was "
                    + DecimalNumber.format(p.maxAbs()));
        }
        return p;
    }

    private Rgb readColor() throws IOException, MeshException {
        return readColor(readNumber());
    }

    private Rgb readColor(double red) throws IOException, MeshException {
        return new Rgb(red, readNumber(), readNumber());
    }
}
