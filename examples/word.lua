-- A filter for pandoc: tables of kurbel, from HTML, as Word wants them.
--
--     kurbel table --ratio 1:5 -f html | pandoc -f html -L word.lua -o tafel.docx
--
-- Figures stand at the right, spanners above the middle of their columns, and columns are as wide as what is
-- in them; notes are lines and no list.

-- In letters: the width of a line, what is beside the text of a cell, and the least column that may be cut.
local LINE, BESIDE, BROAD = 60, 3, 24

local function letters(blocks)
  local text = pandoc.utils.stringify(blocks)
  -- Formulas are counted as they are seen, without the commands of TeX.
  local seen = text:gsub("\\[a-zA-Z]+", "x"):gsub("[{}^_\\]", "")
  return utf8.len(seen) or #seen
end

local function longest_word(blocks)
  local longest = 0
  local function count(one) longest = math.max(longest, letters(one)) end
  pandoc.walk_block(pandoc.Div(blocks), { Str = count, Math = count })
  return longest
end

local function has(cell, class)
  return cell.attr.classes:includes(class)
end

-- Calls a function with each cell and the column that it begins in.
local function each(rows, use)
  local covered = {}
  for number, row in ipairs(rows) do
    local column = 1
    for _, cell in ipairs(row.cells) do
      while covered[number * 1000 + column] do column = column + 1 end
      use(cell, column)
      for down = 0, cell.row_span - 1 do
        for across = 0, cell.col_span - 1 do
          covered[(number + down) * 1000 + column + across] = true
        end
      end
    end
  end
end

-- Angles and ratios of mere figures are text: 84°16′ and 1:5.
local function Math(math)
  local text = math.text:gsub("{^\\circ}", "°"):gsub("\\prime\\prime", "″"):gsub("\\prime", "′")
  local rest = text:gsub("[%d.,:]", ""):gsub("°", ""):gsub("′", ""):gsub("″", "")
  if rest == "" then return pandoc.Str(text) end
end

local function Table(tbl)
  local widths = {}
  for place = 1, #tbl.colspecs do widths[place] = 1 end
  local function widen(cell, column, size)
    if cell.col_span == 1 then widths[column] = math.max(widths[column], size) end
  end
  local figures = {}
  for _, body in ipairs(tbl.bodies) do
    each(body.body, function(cell, column)
      widen(cell, column, letters(cell.contents))
      if cell.col_span == 1 then
        local words = has(cell, "words")
        cell.alignment = words and "AlignLeft" or has(cell, "missing") and "AlignCenter" or "AlignRight"
        figures[column] = figures[column] or not words
      end
    end)
  end
  each(tbl.head.rows, function(cell, column)
    widen(cell, column, longest_word(cell.contents))
    cell.alignment = cell.col_span > 1 and "AlignCenter" or figures[column] and "AlignRight" or "AlignLeft"
  end)
  local fixed, free = 0, 0
  for place, width in ipairs(widths) do
    widths[place] = width + BESIDE
    figures[place] = figures[place] or widths[place] <= BROAD
    if figures[place] then fixed = fixed + widths[place] else free = free + widths[place] end
  end
  -- Words may go on in another line, figures may not.
  local room = LINE - fixed
  if fixed + free > LINE and free > 0 and room > 0 then
    for place, width in ipairs(widths) do
      if not figures[place] then widths[place] = width * room / free end
    end
    free = room
  end
  for place, width in ipairs(widths) do
    tbl.colspecs[place] = { "AlignDefault", width / math.max(fixed + free, LINE) }
  end
  return tbl
end

local function Blocks(blocks)
  local done = pandoc.List()
  for _, block in ipairs(blocks) do
    local before = done[#done]
    if block.t == "Div" and block.classes:includes("narrow") then
      -- The same table again, for telephones.
    elseif block.t == "BulletList" and before and before.t == "Div" and before.classes:includes("scroll") then
      for _, note in ipairs(block.content) do
        for _, line in ipairs(note) do done:insert(pandoc.Para(line.content)) end
      end
    else
      done:insert(block)
    end
  end
  return done
end

-- In this order: columns are as wide as text is.
return { { Math = Math }, { Table = Table, Blocks = Blocks } }
