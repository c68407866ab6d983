-- A filter for pandoc: hands to kurbel what documents of Word have no place for, which are the classes and
-- measures of tables, and has captions counted by fields. kurbel lays out what it finds behind these marks.

local WORDS = {
  de = { table = "Tabelle", figure = "Abbildung" },
  en = { table = "Table", figure = "Figure" },
}
local counts = { table = 0, figure = 0 }

local function escaped(text)
  return (text:gsub("[&<>\"]", { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" }))
end

local function mark(of, what)
  return pandoc.RawBlock("openxml", ('<w:kurbel w:of="%s" w:what="%s"/>'):format(of, escaped(what or "")))
end

-- "Table 3: ", whose number is counted by Word.
local function number(kind, lang)
  counts[kind] = counts[kind] + 1
  local word = (WORDS[lang] or WORDS.en)[kind]
  local run = '<w:r><w:t xml:space="preserve">%s</w:t></w:r>'
  local field = '<w:fldSimple w:instr=" SEQ %s \\* ARABIC ">%s</w:fldSimple>'
  local pieces = run:format(word .. "\u{a0}") .. field:format(word, run:format(counts[kind])) .. run:format(": ")
  return pandoc.RawInline("openxml", pieces)
end

local function styled(name, blocks)
  return pandoc.Div(blocks, { ["custom-style"] = name })
end

-- Angles and ratios of mere figures are text: 84°16′ and 1:5.
local function Math(math)
  local text = math.text:gsub("{^\\circ}", "°"):gsub("\\prime\\prime", "″"):gsub("\\prime", "′")
  local rest = text:gsub("[%d.,:]", ""):gsub("°", ""):gsub("′", ""):gsub("″", "")
  if rest == "" then return pandoc.Str(text) end
end

local function Span(span)
  -- Where a heading may break.
  if span.classes:includes("shy") then return pandoc.RawInline("openxml", "<w:r><w:softHyphen/></w:r>") end
end

-- Files beside the document are none of a page's.
local function Image(image)
  if not image.src:match("^data:image/png;") then return {} end
end

local function rows_marked(rows)
  for _, row in ipairs(rows) do
    local look = table.concat(row.attr.classes, " ")
    for place, cell in ipairs(row.cells) do
      local own = table.concat(cell.attr.classes, " ")
      cell.contents:insert(1, mark("cell", place == 1 and own .. " " .. look or own))
    end
  end
end

local function table_marked(tbl)
  rows_marked(tbl.head.rows)
  for _, body in ipairs(tbl.bodies) do rows_marked(body.body) end
  return { mark("table", tbl.attr.attributes.style), tbl }
end

local function page(div)
  local done, counted = pandoc.List(), false
  local lang = div.attributes.lang
  local function put(block)
    if block.t == "Div" and block.classes:includes("scroll") then
      block.content:map(put)
    elseif block.t == "Table" then
      if not counted then block.caption.long[1].content:insert(1, number("table", lang)) end
      counted = true
      done:extend(table_marked(block))
    elseif block.t == "BulletList" then
      for _, note in ipairs(block.content) do done:insert(styled("Table Notes", note)) end
    else
      done:insert(styled("Table Notes", { block }))
    end
  end
  div.content:map(put)
  return pandoc.Div({ mark("page"), pandoc.Div(done), mark("end") }, pandoc.Attr(div.identifier))
end

local function Div(div)
  if div.classes:includes("kurbel") then return page(div) end
  if div.classes:includes("drawing") then
    local caption = div.content[#div.content]
    caption.content:insert(1, number("figure", div.attributes.lang))
    div.content[#div.content] = styled("Image Caption", { caption })
    return div
  end
end

-- In this order: what stands within a page is set before it.
return { { Math = Math, Span = Span, Image = Image }, { Div = Div } }
